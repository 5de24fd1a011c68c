#include "rodpack/beds.h"
namespace rodpack {
std::string beds_section(const std::vector<BedRow>&, const AccuracySettings&, const BedScene&) {
  return "";
}
std::string bed_guide(const std::vector<BedRow>&, const std::vector<std::string>&, int) {
  return "";
}
void draw_beds(const std::vector<BedRow>&, const std::vector<std::string>&, int,
               const std::string&) {}
}  // namespace rodpack
