#include "recording/import/hdf5_table.h"

#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <vector>

#include "base/contained.h"
#include "recording/import/npy.h"

namespace breakaway {

namespace {

constexpr hsize_t mostTableValues = hsize_t{1} << 28;

/// Closes what the library opened.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

struct FoundSets {
  std::vector<RawColumn> columns;
  bool matlab = false;  ///< names and matrices as MATLAB 7.3 puts them
};

/// The text of the first of these attributes that is there.
std::string textAt(hid_t set, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (H5Aexists(set, name) <= 0) continue;
    const Handle attribute(H5Aopen(set, name, H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING) continue;
    if (H5Tis_variable_str(type) > 0) {
      char* text = nullptr;
      const Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(memory, H5T_VARIABLE);
      H5Tset_cset(memory, H5Tget_cset(type));
      if (H5Aread(attribute, memory, static_cast<void*>(&text)) < 0 || text == nullptr) continue;
      std::string copied(text);
      H5free_memory(text);
      return copied;
    }
    std::string text(std::min<size_t>(H5Tget_size(type), 200), '\0');
    if (H5Tget_size(type) > 200 || H5Aread(attribute, type, text.data()) < 0) continue;
    return text.substr(0, text.find('\0'));
  }
  return {};
}

bool isNumberType(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_ENUM;
}

/// All values of the set, or of one field of its records.
std::vector<double> valuesOf(hid_t set, hsize_t count, const char* field) {
  std::vector<double> values(count);
  if (field == nullptr) {
    if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) return {};
    return values;
  }
  const Handle memory(H5Tcreate(H5T_COMPOUND, sizeof(double)), H5Tclose);
  H5Tinsert(memory, field, 0, H5T_NATIVE_DOUBLE);
  if (H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) return {};
  return values;
}

/// Stamps of 19 digits keep them all, counted from the first.
std::vector<double> stampsOf(hid_t set, hsize_t count, double& origin) {
  std::vector<int64_t> whole(count);
  if (count == 0 || H5Dread(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, whole.data()) < 0) return {};
  std::vector<double> values;
  values.reserve(whole.size());
  const int64_t first = std::abs(static_cast<double>(whole.front())) > 1e15 ? whole.front() : 0;
  origin = static_cast<double>(first);
  for (const int64_t one : whole) values.push_back(static_cast<double>(one - first));
  return values;
}

void add(FoundSets& found, std::string name, std::vector<double> values, const std::string& unit, double origin = 0.0) {
  if (values.empty()) return;
  for (double& value : values) value = std::isfinite(value) ? value : NAN;
  RawColumn column{{std::move(name), std::move(values)}, {}};
  column.unit = unit;
  column.origin = origin;
  found.columns.push_back(std::move(column));
}

/// A variable's values lie column by column, so that HDF5 tells its columns first; texts and references are none.
void addVariable(FoundSets& found, hid_t set, std::string path, const hsize_t* size) {
  const std::string kind = textAt(set, {"MATLAB_class"});
  if (path.starts_with("#") || kind == "char" || kind == "cell" || H5Aexists(set, "MATLAB_empty") > 0) return;
  std::replace(path.begin(), path.end(), '/', '.');
  std::vector<double> values = valuesOf(set, size[0] * size[1], nullptr);
  if (size[0] == 1 || size[1] == 1) return add(found, std::move(path), std::move(values), {});
  for (hsize_t c = 0; c < size[0] && c < 1000 && !values.empty(); ++c) {
    const auto start = values.begin() + static_cast<std::ptrdiff_t>(c * size[1]);
    add(found, path + "_" + std::to_string(c + 1), {start, start + static_cast<std::ptrdiff_t>(size[1])}, {});
  }
}

herr_t visit(hid_t file, const char* path, const H5O_info_t* info, void* data) {
  auto& found = *static_cast<FoundSets*>(data);
  if (info->type != H5O_TYPE_DATASET || found.columns.size() > 5000) return 0;
  const Handle set(H5Dopen2(file, path, H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  const Handle type(H5Dget_type(set), H5Tclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0 || rank > 2) return 0;
  hsize_t size[2] = {1, 1};
  H5Sget_simple_extent_dims(space, size, nullptr);
  if (size[0] == 0 || size[1] == 0 || size[0] > mostTableValues / size[1]) return 0;
  const hsize_t count = size[0] * size[1];
  if (found.matlab) {
    if (isNumberType(type)) addVariable(found, set, path, size);
    return 0;
  }
  const std::string unit = textAt(set, {"units", "unit", "Units", "Unit"});
  if (H5Tget_class(type) == H5T_COMPOUND && rank == 1) {
    for (int k = 0; k < H5Tget_nmembers(type) && k < 1000; ++k) {
      const Handle field(H5Tget_member_type(type, static_cast<unsigned>(k)), H5Tclose);
      char* name = H5Tget_member_name(type, static_cast<unsigned>(k));
      if (name != nullptr && isNumberType(field))
        add(found, std::string(path) + "." + name, valuesOf(set, count, name), "");
      H5free_memory(name);
    }
    return 0;
  }
  if (!isNumberType(type)) return 0;
  if (rank < 2 || size[0] == 1 || size[1] == 1) {
    double origin = 0.0;
    const bool wide = H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) == 8;
    add(found, path, wide ? stampsOf(set, count, origin) : valuesOf(set, count, nullptr), unit, origin);
    return 0;
  }
  const std::vector<double> values = valuesOf(set, count, nullptr);
  if (values.empty()) return 0;
  const bool across = size[0] < size[1] && size[0] <= 64;
  const hsize_t width = across ? size[0] : size[1], rows = across ? size[1] : size[0];
  for (hsize_t c = 0; c < width && width <= 1000; ++c) {
    std::vector<double> column(rows);
    for (hsize_t k = 0; k < rows; ++k) column[k] = across ? values[c * rows + k] : values[k * width + c];
    add(found, std::string(path) + "_" + std::to_string(c + 1), std::move(column), unit);
  }
  return 0;
}

template <typename T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putText(std::string& bytes, const std::string& text) {
  put(bytes, uint64_t{text.size()});
  bytes += text;
}

/// Runs in the contained process: each column as name, unit, origin, count, values.
std::string readSets(std::string_view content, bool matlab) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  std::string bytes;
  const Handle inMemory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(inMemory, 1U << 16U, 0);
  H5Pset_file_image(inMemory, const_cast<char*>(content.data()), content.size());  // which copies it
  const Handle file(H5Fopen("log", H5F_ACC_RDONLY, inMemory), H5Fclose);
  if (file < 0) return bytes;
  FoundSets found;
  found.matlab = matlab;
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, visit, &found);
  for (const RawColumn& column : found.columns) {
    putText(bytes, column.channel.name);
    putText(bytes, column.unit);
    put(bytes, column.origin);
    put(bytes, uint64_t{column.channel.values.size()});
    bytes.append(reinterpret_cast<const char*>(column.channel.values.data()),
                 column.channel.values.size() * sizeof(double));
  }
  return bytes;
}

template <typename T>
T take(const std::string& bytes, size_t& at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

std::string takeText(const std::string& bytes, size_t& at) {
  const auto size = take<uint64_t>(bytes, at);
  std::string text = bytes.substr(at, size);
  at += size;
  return text;
}

}  // namespace

bool isHdf5(std::string_view bytes) {
  return bytes.starts_with("\x89HDF");
}

Result<std::vector<RawColumn>> readHdf5Columns(std::string_view content, const std::string& name, bool matlab) {
  // Room for what the file can honestly unpack to, so that a damaged size fails at once.
  const ContainedLimits limits{20 + static_cast<unsigned>(content.size() >> 20),
                               (size_t{512} << 20) + 64 * content.size()};
  const auto bytes = runContained([&] { return readSets(content, matlab); }, name, limits);
  if (!bytes) return bytes.error();
  std::vector<RawColumn> columns;
  for (size_t at = 0; at < bytes->size();) {
    RawColumn column;
    column.channel.name = takeText(*bytes, at);
    column.unit = takeText(*bytes, at);
    column.origin = take<double>(*bytes, at);
    column.channel.values.resize(take<uint64_t>(*bytes, at));
    std::memcpy(column.channel.values.data(), bytes->data() + at, column.channel.values.size() * sizeof(double));
    at += column.channel.values.size() * sizeof(double);
    columns.push_back(std::move(column));
  }
  return columns;
}

Result<RawTable> readHdf5(std::string_view content, const std::string& name) {
  auto columns = readHdf5Columns(content, name, false);
  if (!columns) return columns.error();
  if (columns->empty()) return Error{name, message("is an HDF5 file that is damaged or holds no vector of numbers")};
  return tableOfColumns(std::move(*columns), name);
}

}  // namespace breakaway
