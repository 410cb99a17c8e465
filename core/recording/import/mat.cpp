#include "recording/import/mat.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>

#include "base/contained.h"
#include "base/memory_file.h"
#include "recording/import/hdf5_table.h"

namespace breakaway {

namespace {

constexpr size_t headerSize = 128;
constexpr size_t mostValues = size_t{1} << 30;

uint32_t word(std::string_view bytes, size_t at, bool swapped) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return swapped ? __builtin_bswap32(value) : value;
}

/// A version 5 file is a header and elements that tell their sizes; the last one must end where the file ends.
Result<void> checkElements(std::string_view bytes, const std::string& name) {
  const bool swapped = bytes[126] == 'M';  // "MI" written by a machine of the other byte order
  size_t at = headerSize;
  while (at < bytes.size()) {
    const size_t size = at + 8 <= bytes.size() ? word(bytes, at + 4, swapped) : 0;
    if (at + 8 > bytes.size() || size > bytes.size() - at - 8) {
      return Error{name, "is cut short: its last variable ends beyond byte " + std::to_string(bytes.size())};
    }
    at += 8 + size;
  }
  return {};
}

/// A file of version 7.3 is HDF5 behind a page of text, or without it.
bool isVersion73(std::string_view bytes) {
  const size_t hdf = bytes.starts_with("MATLAB ") ? 512 : 0;
  return bytes.size() > hdf + 8 && bytes.compare(hdf, 4, "\x89HDF") == 0;
}

/// Whether this is a whole MATLAB file of version 5, as far as that shows without reading the variables.
Result<void> checkVersion5(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) return Error{name, "is empty, expected a MATLAB file"};
  const bool named = bytes.starts_with("MATLAB ");
  if (named && bytes.size() < headerSize) return Error{name, "is cut short within its header"};
  const bool five = named && (bytes.compare(126, 2, "IM") == 0 || bytes.compare(126, 2, "MI") == 0);
  if (bytes.starts_with("MATLAB 7.3")) return Error{name, "is cut short within its header"};
  if (!five) return Error{name, "is no MATLAB file of version 5 or 7.3"};
  return checkElements(bytes, name);
}

template <typename T>
void copyValues(const matvar_t& variable, std::vector<double>& values) {
  const auto* data = static_cast<const T*>(variable.data);
  for (size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(data[k]);
}

struct Kind {
  matio_classes type;
  void (*copy)(const matvar_t& variable, std::vector<double>& values);
};
constexpr auto kinds = std::to_array<Kind>({{MAT_C_DOUBLE, copyValues<double>},
                                            {MAT_C_SINGLE, copyValues<float>},
                                            {MAT_C_INT8, copyValues<int8_t>},
                                            {MAT_C_UINT8, copyValues<uint8_t>},
                                            {MAT_C_INT16, copyValues<int16_t>},
                                            {MAT_C_UINT16, copyValues<uint16_t>},
                                            {MAT_C_INT32, copyValues<int32_t>},
                                            {MAT_C_UINT32, copyValues<uint32_t>},
                                            {MAT_C_INT64, copyValues<int64_t>},
                                            {MAT_C_UINT64, copyValues<uint64_t>}});

/// The array's values column by column; empty when they are no real numbers.
std::vector<double> valuesOf(const matvar_t& variable) {
  if (variable.isComplex != 0 || variable.data == nullptr || variable.rank < 1 || variable.data_size <= 0) return {};
  size_t count = 1;
  for (int k = 0; k < variable.rank; ++k) {
    if (variable.dims[k] > mostValues || count * variable.dims[k] > mostValues) return {};
    count *= variable.dims[k];
  }
  if (count * static_cast<size_t>(variable.data_size) > variable.nbytes) return {};
  std::vector<double> values(count);
  const auto it = std::find_if(kinds.begin(), kinds.end(),
                               [&variable](const Kind& one) { return one.type == variable.class_type; });
  if (it == kinds.end()) return {};
  it->copy(variable, values);
  return values;
}

void addVariable(matvar_t& variable, const std::string& name, int depth, std::vector<Channel>& channels) {
  if (variable.class_type == MAT_C_STRUCT && depth < 4) {
    const unsigned fields = Mat_VarGetNumberOfFields(&variable);
    char* const* names = Mat_VarGetStructFieldnames(&variable);
    for (unsigned k = 0; k < fields; ++k) {
      matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, k, 0);
      if (field != nullptr && names != nullptr) addVariable(*field, name + "." + names[k], depth + 1, channels);
    }
    return;
  }
  std::vector<double> values = valuesOf(variable);
  if (values.empty()) return;
  const size_t rows = variable.dims[0], columns = values.size() / std::max<size_t>(1, rows);
  if (rows == 1 || columns == 1) {
    channels.push_back({name, std::move(values)});
    return;
  }
  for (size_t c = 0; c < columns && c < 1000; ++c) {
    const auto start = values.begin() + static_cast<std::ptrdiff_t>(c * rows);
    channels.push_back({name + "_" + std::to_string(c + 1), {start, start + static_cast<std::ptrdiff_t>(rows)}});
  }
}

template <typename T>
void put(std::string& bytes, const T* data, size_t count) {
  bytes.append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

/// Runs in the contained process: every array as name length, name, count, values.
std::string readVariables(const std::string& path) {
  std::string bytes;
  const std::unique_ptr<mat_t, int (*)(mat_t*)> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (!file) return bytes;
  std::vector<Channel> channels;
  while (matvar_t* variable = Mat_VarReadNext(file.get())) {
    if (variable->name != nullptr) addVariable(*variable, variable->name, 0, channels);
    Mat_VarFree(variable);
  }
  for (const Channel& channel : channels) {
    const uint64_t nameSize = channel.name.size(), count = channel.values.size();
    put(bytes, &nameSize, 1);
    bytes += channel.name;
    put(bytes, &count, 1);
    put(bytes, channel.values.data(), count);
  }
  return bytes;
}

/// HDF5 itself refuses files that end before they say they do.
Result<std::vector<Channel>> readVersion73(std::string_view content, const std::string& name) {
  auto columns = readHdf5Columns(content, name, true);
  if (!columns) return columns.error();
  if (columns->empty()) return Error{name, "is damaged or holds no numeric array"};
  std::vector<Channel> channels;
  for (RawColumn& column : *columns) channels.push_back(std::move(column.channel));
  return channels;
}

uint64_t takeCount(const std::string& bytes, size_t& at) {
  uint64_t count = 0;
  std::memcpy(&count, bytes.data() + at, sizeof count);
  at += sizeof count;
  return count;
}

}  // namespace

Result<std::vector<Channel>> readMat(std::string_view content, const std::string& name) {
  if (isVersion73(content)) return readVersion73(content, name);
  if (const auto whole = checkVersion5(content, name); !whole) return whole.error();
  const MemoryFile file(content);
  if (!file.good()) return Error{name, "cannot be held in memory"};
  // Room for what the file can honestly unpack to, so that a damaged size fails at once.
  const ContainedLimits limits{20 + static_cast<unsigned>(content.size() >> 20),
                               (size_t{512} << 20) + 64 * content.size()};
  const auto bytes = runContained([&file] { return readVariables(file.path()); }, name, limits);
  if (!bytes) return bytes.error();
  if (bytes->empty()) return Error{name, "is damaged or holds no numeric array"};
  std::vector<Channel> channels;
  for (size_t at = 0; at < bytes->size();) {
    const uint64_t nameSize = takeCount(*bytes, at);
    Channel channel{bytes->substr(at, nameSize), {}};
    at += nameSize;
    channel.values.resize(takeCount(*bytes, at));
    std::memcpy(channel.values.data(), bytes->data() + at, channel.values.size() * sizeof(double));
    at += channel.values.size() * sizeof(double);
    channels.push_back(std::move(channel));
  }
  return channels;
}

}  // namespace breakaway
