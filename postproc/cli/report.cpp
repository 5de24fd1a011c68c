// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include "cli/checks.h"
#include "cli/commands.h"
#include "page/report_page.h"

namespace rodpack::cli {

void add_report(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  auto* command = app.add_subcommand(
      "report",
      "One HTML page of a study or a run that was analysed: tables, figures, packings that can be "
      "zoomed and asked. It needs no network and no other file.");
  command->footer(
      "Examples:\n"
      "  rodpack report results/study\n"
      "after \"rodpack ensemble results/study\", writes results/study/report.html;\n"
      "  rodpack report results/quick\n"
      "writes results/quick/analysis/report.html anew, as \"rodpack analyse\" does.");
  command->add_option("folder", *folder, "folder of a study, or of a run")
      ->required()
      ->check(some_name())
      ->type_name("FOLDER");
  command->callback([folder] {
    const auto page = write_report_page(*folder);
    std::cout << "written: " << page << '\n';
  });
}

}  // namespace rodpack::cli
