#include "recording/import/mat.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>

#include "base/contained.h"
#include "base/memory_file.h"
#include "recording/import/controldesk.h"
#include "recording/import/gzip.h"
#include "recording/import/hdf5_table.h"
#include "recording/import/text_encoding.h"

namespace breakaway {

namespace {

constexpr size_t headerSize = 128;
constexpr uint32_t packed = 15;  // an element of any kind, by zlib
constexpr size_t mostValues = size_t{1} << 30;

uint32_t word(std::string_view bytes, size_t at, bool swapped) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return swapped ? __builtin_bswap32(value) : value;
}

/// A version 5 file is a header and elements that tell their sizes; the last one must end where the file ends. The
/// library reads on over a wrong checksum, as values that nobody wrote.
Result<void> checkElements(std::string_view bytes, const std::string& name) {
  const bool swapped = bytes[126] == 'M';  // "MI" written by a machine of the other byte order
  size_t at = headerSize;
  while (at < bytes.size()) {
    const size_t size = at + 8 <= bytes.size() ? word(bytes, at + 4, swapped) : 0;
    if (at + 8 > bytes.size() || size > bytes.size() - at - 8) {
      return Error{name, message("is cut short: its last variable ends beyond byte {}", bytes.size())};
    }
    if (word(bytes, at, swapped) == packed && isDamagedZlib(bytes.substr(at + 8, size))) {
      return Error{name, message("is damaged: the variable at byte {} can't be unpacked", at)};
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
  if (bytes.empty()) return Error{name, message("is empty, expected a MATLAB file")};
  const bool named = bytes.starts_with("MATLAB ");
  if (named && bytes.size() < headerSize) return Error{name, message("is cut short within its header")};
  const bool five = named && (bytes.compare(126, 2, "IM") == 0 || bytes.compare(126, 2, "MI") == 0);
  if (bytes.starts_with("MATLAB 7.3")) return Error{name, message("is cut short within its header")};
  if (!five) return Error{name, message("is no MATLAB file of version 5 or 7.3")};
  return checkElements(bytes, name);
}

template <typename T>
void copyValues(const matvar_t& variable, std::vector<double>& values) {
  const auto* data = static_cast<const T*>(variable.data);
  for (size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(data[k]);
}

struct NumberKind {
  matio_classes type;
  void (*copy)(const matvar_t& variable, std::vector<double>& values);
};
constexpr auto numberKinds = std::to_array<NumberKind>({{MAT_C_DOUBLE, copyValues<double>},
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
  const auto it = std::find_if(numberKinds.begin(), numberKinds.end(),
                               [&variable](const NumberKind& one) { return one.type == variable.class_type; });
  if (it == numberKinds.end()) return {};
  it->copy(variable, values);
  return values;
}

/// What the characters say, in UTF-8.
std::string textOf(const matvar_t& variable) {
  constexpr size_t longest = 1000;
  if (variable.class_type != MAT_C_CHAR || variable.data == nullptr || variable.data_size <= 0) return {};
  const size_t size = static_cast<size_t>(variable.data_size);
  const size_t count = std::min(longest, variable.nbytes / size);
  std::string text;
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  for (size_t k = 0; k < count; ++k) {
    const unsigned code = size == 1 ? bytes[k] : bytes[k * size] | static_cast<unsigned>(bytes[k * size + 1]) << 8U;
    if (size == 1 || code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
    }
  }
  std::string buffer;
  return std::string(inUtf8(text, buffer));
}

/// One element of an array of structures.
struct Element {
  matvar_t& array;
  size_t place = 0;

  static size_t countOf(const matvar_t& array) {
    size_t count = 1;
    for (int k = 0; k < array.rank; ++k) count = std::min(mostValues, count * std::min(array.dims[k], mostValues));
    return count;
  }
  matvar_t* field(const char* name) const {
    return array.class_type == MAT_C_STRUCT && place < countOf(array) ? Mat_VarGetStructFieldByName(&array, name, place)
                                                                      : nullptr;
  }
  matvar_t* firstField(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (matvar_t* found = field(name)) return found;
    }
    return nullptr;
  }
  std::string text(std::initializer_list<const char*> names) const {
    const matvar_t* found = firstField(names);
    return found == nullptr ? std::string() : textOf(*found);
  }
  /// The signal that it holds beside its name and unit, if it is one.
  matvar_t* signal() const { return firstField({"Data", "data", "values", "Values"}); }
};

std::string withUnit(const std::string& name, const Element& element) {
  const std::string unit = element.text({"Unit", "unit", "Units", "units"});
  return unit.empty() || unit == "-" ? name : name + " [" + unit + "]";
}

/// What each of the stamps saw last.
std::vector<double> heldAt(const std::vector<double>& stamps, const std::vector<double>& of,
                           const std::vector<double>& values) {
  std::vector<double> held;
  size_t next = 0;
  for (const double now : stamps) {
    while (next < of.size() && of[next] <= now) ++next;
    held.push_back(next == 0 ? NAN : values[next - 1]);
  }
  return held;
}

/// ControlDesk's structure: stamps in X, one element a raster, signals in Y, whose XIndex names theirs. Those of other
/// rasters than the first signal's hold their last value, and are called so. False: it is none.
bool addControlDesk(const Element& structure, const std::string& name, std::vector<Channel>& channels) {
  matvar_t *stamps = structure.field("X"), *signals = structure.field("Y");
  if (stamps == nullptr || signals == nullptr) return false;
  std::vector<std::vector<double>> rasters;
  for (size_t k = 0; k < std::min<size_t>(1000, Element::countOf(*stamps)); ++k) {
    const matvar_t* data = Element{*stamps, k}.signal();
    rasters.push_back(data == nullptr ? std::vector<double>() : valuesOf(*data));
  }
  const size_t count = std::min<size_t>(5000, Element::countOf(*signals));
  const auto rasterOf = [&](size_t k) {
    const matvar_t* index = Element{*signals, k}.field("XIndex");
    const std::vector<double> said = index == nullptr ? std::vector<double>() : valuesOf(*index);
    return said.size() == 1 && said[0] >= 1.0 && said[0] <= static_cast<double>(rasters.size())
               ? static_cast<size_t>(said[0]) - 1
               : size_t{0};
  };
  if (count == 0 || rasters.empty() || rasters[rasterOf(0)].size() < 2) return false;
  size_t main = rasterOf(0);
  for (size_t k = 0; k < count; ++k) {
    if (rasters[rasterOf(k)].size() > rasters[main].size()) main = rasterOf(k);
  }
  const std::string prefix = channels.empty() ? "" : name + ".";  // numbers in it would be taken for those of axes
  channels.push_back({withUnit(prefix + "time", {*stamps, main}), rasters[main]});
  for (size_t k = 0; k < count; ++k) {
    const Element signal{*signals, k};
    const matvar_t* data = signal.signal();
    if (data == nullptr) continue;
    const size_t raster = rasterOf(k);
    std::vector<double> values = valuesOf(*data);
    if (values.empty()) continue;
    std::string called = nameInModel(signal.text({"Name", "name"}), signal.text({"Path", "path"}));
    if (called.empty()) called = "signal " + std::to_string(k + 1);
    const bool held = raster != main && values.size() == rasters[raster].size();
    if (held) values = heldAt(rasters[main], rasters[raster], values);
    channels.push_back({withUnit(prefix + (held ? "held." : "") + called, signal), std::move(values)});
  }
  return true;
}

void addVariable(matvar_t& variable, const std::string& name, int depth, std::vector<Channel>& channels);

/// The fields of each element; a signal is called by the name that it has, if it has one.
void addStructure(matvar_t& variable, const std::string& name, int depth, std::vector<Channel>& channels) {
  const unsigned fields = Mat_VarGetNumberOfFields(&variable);
  char* const* names = Mat_VarGetStructFieldnames(&variable);
  const size_t count = std::min<size_t>(1000, Element::countOf(variable));
  for (size_t place = 0; place < count && names != nullptr; ++place) {
    const Element element{variable, place};
    if (addControlDesk(element, name, channels)) continue;
    const matvar_t* signal = element.signal();
    const std::string called =
        signal == nullptr ? std::string() : element.text({"Name", "name", "label", "Label", "title"});
    std::string path = name;
    if (count > 1 && called.empty()) path += "(" + std::to_string(place + 1) + ")";
    if (!called.empty()) path += "." + called;
    for (unsigned k = 0; k < fields; ++k) {
      matvar_t* field = Mat_VarGetStructFieldByIndex(&variable, k, place);
      if (field == nullptr) continue;
      const bool said = field == signal && !called.empty();
      addVariable(*field, said ? withUnit(path, element) : path + "." + names[k], depth + 1, channels);
    }
  }
}

void addVariable(matvar_t& variable, const std::string& name, int depth, std::vector<Channel>& channels) {
  if (variable.class_type == MAT_C_STRUCT && depth < 4) {
    addStructure(variable, name, depth, channels);
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
    // Without a name stands what MATLAB keeps for itself, or what is left of a damaged file.
    if (variable->name != nullptr && *variable->name != '\0') addVariable(*variable, variable->name, 0, channels);
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
  if (columns->empty()) return Error{name, message("is damaged or holds no numeric array")};
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
  if (!file.good()) return Error{name, message("cannot be held in memory")};
  // Room and time for what the file can honestly unpack to, so that a damaged size fails soon.
  const ContainedLimits limits{3 + static_cast<unsigned>(content.size() >> 20),
                               (size_t{512} << 20) + 64 * content.size()};
  const auto bytes = runContained([&file] { return readVariables(file.path()); }, name, limits);
  if (!bytes) return bytes.error();
  if (bytes->empty()) return Error{name, message("is damaged or holds no numeric array")};
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
