#include "recording/import/wpilog.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "recording/import/signal_log.h"

namespace breakaway {

namespace {

constexpr std::string_view wpilogMagic("WPILOG", 6);

/// Little-endian bytes as a number.
uint64_t numberOf(std::string_view bytes) {
  uint64_t value = 0;
  for (size_t k = 0; k < bytes.size() && k < 8; ++k)
    value |= static_cast<uint64_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
  return value;
}

struct Entry {
  std::string name, type;
  Signal signal;
  std::map<std::string, double> texts;  ///< numbers of the texts seen
};

struct Record {
  uint64_t entry = 0, time_us = 0;
  std::string_view payload;
};

/// Takes the next record off `rest`; false when what is left is none.
bool takeRecord(std::string_view& rest, Record& record) {
  if (rest.empty()) return false;
  const auto lengths = static_cast<unsigned char>(rest.front());
  const size_t idSize = (lengths & 3U) + 1, payloadSize = ((lengths >> 2U) & 3U) + 1,
               timeSize = ((lengths >> 4U) & 7U) + 1;
  const size_t head = 1 + idSize + payloadSize + timeSize;
  if (rest.size() < head) return false;
  record.entry = numberOf(rest.substr(1, idSize));
  const uint64_t size = numberOf(rest.substr(1 + idSize, payloadSize));
  record.time_us = numberOf(rest.substr(1 + idSize + payloadSize, timeSize));
  if (size > rest.size() - head) return false;
  record.payload = rest.substr(head, size);
  rest.remove_prefix(head + size);
  return true;
}

/// A text with its length before it.
std::string takeText(std::string_view& rest) {
  if (rest.size() < 4) return {};
  const uint64_t size = numberOf(rest.substr(0, 4));
  rest.remove_prefix(4);
  std::string text(rest.substr(0, size));
  rest.remove_prefix(std::min<size_t>(size, rest.size()));
  return text;
}

/// Metadata is the unit itself, or JSON that names it.
std::string unitIn(const std::string& metadata) {
  const size_t key = metadata.find("\"unit");
  if (key == std::string::npos) return metadata.find('{') == std::string::npos ? metadata : std::string();
  const size_t colon = metadata.find(':', key);
  const size_t open = colon == std::string::npos ? colon : metadata.find('"', colon);
  const size_t close = open == std::string::npos ? open : metadata.find('"', open + 1);
  return close == std::string::npos ? std::string() : metadata.substr(open + 1, close - open - 1);
}

/// SysId's routine puts what is measured first, "position-left-Drivetrain"; here it is the last word.
std::string quantityLast(const std::string& name) {
  for (const char* quantity : {"position", "velocity", "voltage", "current"}) {
    const std::string begin = std::string(quantity) + "-";
    if (name.starts_with(begin)) return name.substr(begin.size()) + " " + quantity;
  }
  return name;
}

void start(std::string_view payload, std::map<uint64_t, Entry>& entries) {
  if (payload.size() < 5 || payload[0] != 0) return;
  const uint64_t id = numberOf(payload.substr(1, 4));
  payload.remove_prefix(5);
  Entry entry;
  entry.name = quantityLast(takeText(payload));
  entry.type = takeText(payload);
  entry.signal.name = entry.name;
  entry.signal.unit = unitIn(takeText(payload));
  entries.try_emplace(id, std::move(entry));
}

void add(const Record& record, Entry& entry) {
  double value = NAN;
  if (entry.type == "double" && record.payload.size() >= 8) {
    std::memcpy(&value, record.payload.data(), 8);
  } else if (entry.type == "float" && record.payload.size() >= 4) {
    float narrow = 0.0F;
    std::memcpy(&narrow, record.payload.data(), 4);
    value = narrow;
  } else if (entry.type == "int64" && record.payload.size() >= 8) {
    value = static_cast<double>(static_cast<int64_t>(numberOf(record.payload)));
  } else if (entry.type == "boolean" && !record.payload.empty()) {
    value = record.payload[0] != 0 ? 1.0 : 0.0;
  } else if (entry.type == "string" && entry.name.find("state") != std::string::npos) {
    const auto next = static_cast<double>(entry.texts.size());
    value = entry.texts.try_emplace(std::string(record.payload.substr(0, 60)), next).first->second;
  } else {
    return;
  }
  entry.signal.stamps.push_back({static_cast<int64_t>(record.time_us), 0.0});
  entry.signal.values.push_back(std::isfinite(value) ? value : NAN);
}

}  // namespace

bool isWpilog(std::string_view bytes) {
  return bytes.starts_with(wpilogMagic);
}

Result<RawTable> readWpilog(std::string_view bytes, const std::string& name) {
  if (bytes.size() < 12) return Error{name, message("is a WPILOG that is cut short")};
  const uint64_t extra = numberOf(bytes.substr(8, 4));
  if (extra > bytes.size() - 12) return Error{name, message("is a WPILOG that is cut short")};
  std::string_view rest = bytes.substr(12 + extra);
  std::map<uint64_t, Entry> entries;
  Record record;
  while (takeRecord(rest, record)) {
    if (record.entry == 0) {
      start(record.payload, entries);
    } else if (const auto it = entries.find(record.entry); it != entries.end()) {
      add(record, it->second);
    }
  }
  std::vector<Signal> signals;
  signals.reserve(entries.size());
  for (auto& [id, entry] : entries) signals.push_back(std::move(entry.signal));
  auto table = tableOfSignals(signals, {"time", "us"}, message("a WPILOG"), name);
  if (!table) return table.error();
  if (!rest.empty()) table->remarks.push_back(message("the log's last record is cut short and was left out"));
  for (const auto& [id, entry] : entries) {
    for (const auto& [text, number] : entry.texts)
      table->remarks.push_back(message("{}: {} is \"{}\"", entry.name, static_cast<int>(number), text));
  }
  return table;
}

}  // namespace breakaway
