// write_rig_header RIG.rig.json HEADER: what the emulated board's build runs first.
#include <cstdio>

#include "base/atomic_file.h"
#include "firmware_link/board/cortex_m3/host/rig_tables.h"

int main(int argc, char** argv) {
  using namespace breakaway;
  const auto refuse = [](const Error& error) {
    std::fprintf(stderr, "%s %s\n", error.place.c_str(), error.fact.c_str());
    return 2;
  };
  if (argc != 3) return refuse({"write_rig_header", "takes two arguments, expected RIG.rig.json and HEADER"});
  const auto rig = readRig(argv[1]);
  if (!rig) return refuse(rig.error());
  const auto tables = rigTables(*rig);
  if (!tables) return refuse({std::string(argv[1]) + ", " + tables.error().place, tables.error().fact});
  const auto written = writeFile(argv[2], rigHeader(*tables, *rig));
  return written ? 0 : refuse(written.error());
}
