#include "friction/map_mat.h"

#include <matio.h>

#include <memory>
#include <vector>

#include "base/atomic_file.h"
#include "base/memory_file.h"
#include "friction/map_table.h"

namespace breakaway {

namespace {

bool writeVector(mat_t* file, const std::string& name, std::vector<double> values) {
  size_t shape[2] = {values.size(), 1};
  const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(
      Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape, values.data(), MAT_F_DONT_COPY_DATA),
      Mat_VarFree);
  return variable != nullptr && Mat_VarWrite(file, variable.get(), MAT_COMPRESSION_NONE) == 0;
}

}  // namespace

Result<void> writeMapMat(const FrictionMap& map, const std::string& path) {
  // matio prints its own reasons otherwise; the result says what failed.
  Mat_LogInitFunc("breakaway", [](int, char*) {});
  const MemoryFile bytes;
  mat_t* file = Mat_CreateVer(bytes.path().c_str(), "Breakaway friction map", MAT_FT_MAT5);
  if (file == nullptr) return Error{path, "cannot be written"};
  bool good = true;
  for (MapColumn& column : mapTable(map)) good = good && writeVector(file, column.name, std::move(column.values));
  good = good && writeVector(file, nameOn(map.axis, "coulomb_average_Nm"),
                             {map.coulombAverage_Nm.value, map.coulombAverage_Nm.standardError});
  good = good && writeVector(file, nameOn(map.axis, "viscous_average_Nm_s_per_rad"),
                             {map.viscousAverage_Nm_s_per_rad.value, map.viscousAverage_Nm_s_per_rad.standardError});
  good = good && writeVector(file, nameOn(map.axis, "total_velocity_rad_per_s"), {map.totalVelocity_rad_per_s});
  good = Mat_Close(file) == 0 && good;
  if (!good) return Error{path, "cannot be written whole"};
  return writeFile(path, bytes.content());
}

}  // namespace breakaway
