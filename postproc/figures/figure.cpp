// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "reading/dump.h"
#include "reading/number_text.h"
#include "programs/run_program.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

// Writes a gnuplot string in single quotes, where a quote is written twice.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

// What gnuplot says beside the line of the script and a mark where it stopped: "line 26: x range is
// invalid".
std::string reason_in(const std::string& said) {
  std::istringstream lines(said);
  std::string reason;
  for (std::string line; std::getline(lines, line);) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    if (line.compare(begin, 5, "line ") == 0) reason = line.substr(begin);
  }
  return reason.empty() ? "" : ": " + reason;
}

// In the folder of the figure, so that the script holds its name alone. What gnuplot says goes to a
// file without a name: one in a folder for all could be somebody else's.
void run_gnuplot(const std::string& figure, const std::filesystem::path& folder,
                 const std::string& script) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> log(std::tmpfile(), std::fclose);
  if (!log) throw DataError("no temporary file for what gnuplot says");
  const std::string name = "/proc/self/fd/" + std::to_string(::fileno(log.get()));
  const int status = run_program({"gnuplot"}, {script, folder.string(), name, {}});
  const std::string said = read_text(name);
  if (status == 127) throw DataError("gnuplot was not found: install gnuplot-nox");
  if (status != 0) throw DataError(figure + ": gnuplot failed to draw it" + reason_in(said));
  std::fputs(said.c_str(), stderr);  // warnings
}

// SVG readers may drop the spaces around a change of font, as before the italic symbol in
// "distance r", unless the file says that they count.
void keep_spaces(const std::string& svg) {
  std::string text = read_text(svg);
  const std::string root = "<svg ";
  const auto at = text.find(root);
  if (at == std::string::npos) throw DataError(svg + ": gnuplot wrote no SVG");
  write_text(svg, text.insert(at + root.size(), "xml:space=\"preserve\" "));
}

}  // namespace

std::string datablock(const std::string& name, const std::vector<std::vector<double>>& columns) {
  std::string text = "$" + name + " << EOD\n";
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    if (std::any_of(columns.begin(), columns.end(),
                    [row](const std::vector<double>& column) { return std::isnan(column[row]); })) {
      text += '\n';
      continue;
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += number_text(columns[c][row]) + (c + 1 < columns.size() ? ' ' : '\n');
  }
  return text + "EOD\n";
}

void draw_figure(const std::string& stem, double aspect, const std::string& commands,
                 double columns) {
  const auto size = [&](double column) {
    const double width = std::round(columns * column);
    return number_text(width) + "," + number_text(std::round(width / aspect));
  };
  const std::string style =
      "set encoding utf8\n"
      "set border 15 linewidth 1.2 linecolor '#202020'\n"
      "set tics scale 0.8 front\n"
      "set mxtics 2\nset mytics 2\n"
      "set style fill solid 1 noborder\n"
      "set key noautotitle samplen 1.8 spacing 1.2\n";
  const std::filesystem::path path(stem);
  const auto name = path.filename().string();
  for (const char each : name)
    if (static_cast<unsigned char>(each) < ' ')
      throw DataError(stem + ": expected a name of a figure without line ends and the like");
  for (const std::string suffix : {".png", ".svg"}) {
    // Removed first, so that a file that exists afterwards is a new one.
    std::error_code ignored;
    std::filesystem::remove(stem + suffix, ignored);
    const std::string terminal =
        suffix == ".png"
            ? "pngcairo size " + size(1600) +
                  " font 'DejaVu Sans,34' linewidth 3 pointscale 3.5 enhanced\n"
            : "svg size " + size(640) + " font 'DejaVu Sans,14' linewidth 1.2 enhanced\n";
    // With ./ before it, no name is taken for a command ("|...").
    run_gnuplot(stem + suffix, path.parent_path(),
                "set terminal " + terminal + "set output " + quoted("./" + name + suffix) + "\n" +
                    style + commands);
    if (!std::filesystem::exists(stem + suffix) || std::filesystem::file_size(stem + suffix) == 0)
      throw DataError(stem + suffix + ": cannot be written");
  }
  keep_spaces(stem + ".svg");
}

}  // namespace rodpack
