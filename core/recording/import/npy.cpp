#include "recording/import/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/exact_text.h"

namespace breakaway {

namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::string_view magic("\x93NUMPY", 6);

/// "<f8", "|b1", ">i4", "<M8[ns]".
struct Type {
  char kind = 0;
  size_t size = 0;
  bool swapped = false;
  double unit_s = 0.0;  ///< of dates and durations
};

std::optional<Type> typeOf(std::string_view text) {
  Type type;
  if (text.size() < 2) return std::nullopt;
  if (text.front() == '>' || text.front() == '<' || text.front() == '|' || text.front() == '=') {
    type.swapped = text.front() == '>';
    text.remove_prefix(1);
  }
  type.kind = text.front();
  const auto [stop, code] = std::from_chars(text.data() + 1, text.data() + text.size(), type.size);
  if (code != std::errc() || type.size == 0) return std::nullopt;
  const std::string_view rest(stop, static_cast<size_t>(text.data() + text.size() - stop));
  if (type.kind == 'M' || type.kind == 'm') {
    type.unit_s = rest == "[ns]" ? 1e-9 : rest == "[us]" ? 1e-6 : rest == "[ms]" ? 1e-3 : rest == "[s]" ? 1.0 : 0.0;
    if (type.unit_s == 0.0 || type.size != 8) return std::nullopt;
  }
  if (std::strchr("fiubMm", type.kind) == nullptr && type.kind != 'U' && type.kind != 'S' && type.kind != 'V')
    return std::nullopt;
  if (type.kind == 'U') type.size *= 4;
  return type;
}

bool isNumberType(const Type& type) {
  const size_t s = type.size;
  if (type.kind == 'f') return s == 2 || s == 4 || s == 8;
  if (type.kind == 'b') return s == 1;
  return (type.kind == 'i' || type.kind == 'u' || type.kind == 'M' || type.kind == 'm') &&
         (s == 1 || s == 2 || s == 4 || s == 8);
}

double halfFloat(uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double value = exponent == 0    ? std::ldexp(fraction, -24)
                       : exponent == 31 ? std::numeric_limits<double>::quiet_NaN()
                                        : std::ldexp(1024 + fraction, exponent - 25);
  return (bits & 0x8000) != 0 ? -value : value;
}

template <typename T>
T as(const unsigned char* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Values at `start`, every `stride` bytes.
RawColumn valuesAt(const char* start, size_t count, size_t stride, const Type& type, std::string name) {
  RawColumn column{{std::move(name), {}}, {}};
  auto& values = column.channel.values;
  values.reserve(count);
  int64_t origin = 0;
  for (size_t k = 0; k < count; ++k) {
    unsigned char bytes[8] = {};
    std::memcpy(bytes, start + k * stride, type.size);
    if (type.swapped) std::reverse(bytes, bytes + type.size);
    if (type.kind == 'f') {
      const double value = type.size == 8   ? as<double>(bytes)
                           : type.size == 4 ? as<float>(bytes)
                                            : halfFloat(as<uint16_t>(bytes));
      values.push_back(std::isfinite(value) ? value : NAN);
      continue;
    }
    int64_t whole = 0;
    if (type.kind == 'u' || type.kind == 'b') {
      whole = static_cast<int64_t>(as<uint64_t>(bytes));
    } else {
      whole = type.size == 8   ? as<int64_t>(bytes)
              : type.size == 4 ? as<int32_t>(bytes)
              : type.size == 2 ? as<int16_t>(bytes)
                               : as<int8_t>(bytes);
    }
    if (k == 0 && std::abs(static_cast<double>(whole)) > 1e15) {
      origin = whole;
      column.origin = static_cast<double>(origin);
    }
    const bool notATime = type.unit_s > 0.0 && whole == std::numeric_limits<int64_t>::min();
    values.push_back(notATime ? NAN
                              : static_cast<double>(static_cast<int64_t>(static_cast<uint64_t>(whole) -
                                                                         static_cast<uint64_t>(origin))));
  }
  if (type.unit_s > 0.0)
    column.unit = type.unit_s == 1.0 ? "s" : type.unit_s == 1e-3 ? "ms" : type.unit_s == 1e-6 ? "us" : "ns";
  return column;
}

/// The text between quotes that follows `key` in the header's dictionary.
std::optional<std::string> quotedAfter(std::string_view header, std::string_view key) {
  const size_t at = header.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const size_t open = header.find_first_not_of(" :", at + key.size());
  if (open == std::string_view::npos || (header[open] != '\'' && header[open] != '"')) return std::nullopt;
  const size_t close = header.find(header[open], open + 1);
  if (close == std::string_view::npos) return std::nullopt;
  return std::string(header.substr(open + 1, close - open - 1));
}

struct Field {
  std::string name;
  Type type;
  size_t offset = 0;
};

/// [('t', '<f8'), ('pos', '<f4')]
std::optional<std::vector<Field>> fieldsOf(std::string_view header) {
  const size_t at = header.find("'descr'");
  const size_t open = at == std::string_view::npos ? at : header.find('[', at);
  const size_t close = open == std::string_view::npos ? open : header.find(']', open);
  if (close == std::string_view::npos) return std::nullopt;
  std::vector<std::string> texts;
  for (size_t k = open; k < header.size() && texts.size() < 20000;) {
    if (header[k] == ')' && header.find_first_not_of(" ,", k + 1) != std::string_view::npos &&
        header[header.find_first_not_of(" ,", k + 1)] == ']')
      break;
    if (header[k] != '\'') {
      ++k;
      continue;
    }
    const size_t end = header.find('\'', k + 1);
    if (end == std::string_view::npos) return std::nullopt;
    texts.emplace_back(header.substr(k + 1, end - k - 1));
    k = end + 1;
  }
  std::vector<Field> fields;
  size_t offset = 0;
  for (size_t k = 0; k + 1 < texts.size(); k += 2) {
    const auto type = typeOf(texts[k + 1]);
    if (!type) return std::nullopt;
    fields.push_back({texts[k], *type, offset});
    offset += type->size;
  }
  return fields;
}

std::vector<size_t> shapeOf(std::string_view header) {
  std::vector<size_t> shape;
  const size_t at = header.find("'shape'");
  const size_t open = at == std::string_view::npos ? at : header.find('(', at);
  if (open == std::string_view::npos) return {0, 0, 0};
  for (size_t k = open + 1; k < header.size() && header[k] != ')';) {
    size_t value = 0;
    const auto [stop, code] = std::from_chars(header.data() + k, header.data() + header.size(), value);
    if (code == std::errc()) shape.push_back(value);
    k = std::max(k + 1, static_cast<size_t>(stop - header.data()));
  }
  return shape;
}

std::string lastPart(const std::string& name) {
  return name.ends_with(".npy") ? name.substr(0, name.size() - 4) : name;
}

}  // namespace

bool isNpy(std::string_view bytes) {
  return bytes.starts_with(magic);
}

Result<std::vector<RawColumn>> readNpy(std::string_view bytes, const std::string& name, const std::string& place) {
  const Error cut{place, message("is a NumPy array that is cut short")};
  if (bytes.size() < 12) return cut;
  const bool wide = bytes[6] >= 2;
  size_t length = 0;
  std::memcpy(&length, bytes.data() + 8, wide ? 4 : 2);
  const size_t start = wide ? 12 : 10;
  if (length > bytes.size() - start) return cut;
  const std::string_view header = bytes.substr(start, length);
  const std::string_view data = bytes.substr(start + length);
  const auto shape = shapeOf(header);
  if (shape.size() > 2) return Error{place, message("is a NumPy array of more than two dimensions")};
  size_t count = 1;
  for (const size_t one : shape) {
    if (one != 0 && count > (size_t{1} << 32) / one) return cut;
    count *= one;
  }
  std::vector<RawColumn> columns;
  const auto descr = quotedAfter(header, "'descr'");
  if (!descr) {
    const auto fields = fieldsOf(header);
    if (!fields || fields->empty() || shape.size() > 1)
      return Error{place, message("is a NumPy array of other than numbers")};
    const size_t stride = fields->back().offset + fields->back().type.size;
    if (count > data.size() / stride) return cut;
    for (const Field& field : *fields) {
      if (isNumberType(field.type))
        columns.push_back(valuesAt(data.data() + field.offset, count, stride, field.type, field.name));
    }
    return columns;
  }
  const auto type = typeOf(*descr);
  if (!type || !isNumberType(*type))
    return Error{place, message("is a NumPy array of {}, not of real numbers", *descr)};
  if (count > data.size() / type->size) return cut;
  if (shape.size() < 2) {
    columns.push_back(valuesAt(data.data(), count, type->size, *type, name));
    return columns;
  }
  const bool fortran = header.find("'fortran_order': True") != std::string_view::npos;
  // Samples lie along the longer side.
  const bool across = shape[0] < shape[1] && shape[0] <= 64;
  const size_t rows = across ? shape[1] : shape[0], width = across ? shape[0] : shape[1];
  if (width > 1000) return Error{place, message("is a NumPy array of {} columns, too many for a log", width)};
  const bool adjacent = fortran != across;  // a column's values lie side by side
  for (size_t c = 0; c < width; ++c) {
    const size_t offset = c * (adjacent ? rows : 1) * type->size;
    columns.push_back(valuesAt(data.data() + offset, rows, type->size * (adjacent ? 1 : width), *type,
                               name + "_" + std::to_string(c + 1)));
  }
  return columns;
}

bool isNpz(const ZipArchive& archive) {
  const auto members = archive.members();
  return std::any_of(members.begin(), members.end(), [](const std::string& one) { return one.ends_with(".npy"); });
}

Result<RawTable> tableOfColumns(std::vector<RawColumn> columns, const std::string& place) {
  RawTable table;
  size_t rows = 0;
  for (const RawColumn& column : columns) rows = std::max(rows, column.channel.values.size());
  if (rows < 2) return Error{place, message("holds single numbers only, expected vectors over time")};
  for (RawColumn& column : columns) {
    const auto& values = column.channel.values;
    if (values.size() == rows) {
      table.columns.push_back(std::move(column));
    } else if (values.size() == 1) {
      table.notes.emplace_back(column.channel.name, exactText(values.front() + column.origin));
    } else {
      table.remarks.push_back(
          message("{} has {} values, not {}, and was left out", column.channel.name, values.size(), rows));
    }
  }
  return table;
}

Result<RawTable> readNpz(const ZipArchive& archive, const std::string& place) {
  std::vector<RawColumn> columns;
  std::vector<Message> remarks;
  for (const std::string& member : archive.members()) {
    if (!member.ends_with(".npy")) continue;
    const auto bytes = archive.read(member);
    if (!bytes) return bytes.error();
    auto read = isNpy(*bytes)
                    ? readNpy(*bytes, lastPart(member), place + ", " + member)
                    : Result<std::vector<RawColumn>>(Error{place + ", " + member, message("is no NumPy array")});
    if (!read) {
      remarks.push_back(message("{} {} and was left out", member, read.error().fact));
      continue;
    }
    for (RawColumn& column : *read) columns.push_back(std::move(column));
  }
  auto table = tableOfColumns(std::move(columns), place);
  if (table) table->remarks.insert(table->remarks.end(), remarks.begin(), remarks.end());
  return table;
}

}  // namespace breakaway
