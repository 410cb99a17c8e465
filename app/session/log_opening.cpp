#include "session/log_opening.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "base/atomic_file.h"
#include "recording/block_file.h"
#include "recording/columns.h"
#include "recording/import/known_logs.h"

namespace breakaway {

namespace {

constexpr size_t valuesShown = 4;

/// Left aside under a name that means nothing.
std::string asideName(const std::string& column) {
  std::string name = "unused_" + column;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::string_view(",\"#\n").find(c) != std::string_view::npos; },
      '_');
  return name;
}

/// Columns as the file has them, nothing understood yet.
std::vector<LogColumn> bareColumns(const RawTable& table) {
  std::vector<LogColumn> columns;
  for (const RawColumn& raw : table.columns) {
    LogColumn column;
    column.name = QString::fromStdString(raw.channel.name);
    column.unit = QString::fromStdString(raw.unit);
    for (size_t k = 0; k < std::min(valuesShown, raw.channel.values.size()); ++k)
      column.first.push_back(raw.channel.values[k] + raw.origin);
    columns.push_back(std::move(column));
  }
  return columns;
}

/// The table as a recording; of one that the map parts, its part of that number, with the values of all in `parts`.
Result<Imported> settled(const ReadTable& read, const ImportMap& map, const std::string& path, int part,
                         QStringList& parts) {
  if (map.split.empty()) return settleTable(RawTable(read.table), map, path, read.newPart);
  auto tables = partsByColumn(read.table, map.split, path);
  if (!tables) return tables.error();
  for (const RawTable& one : *tables) parts << QString::fromStdString(one.notes.back().second);
  if (tables->empty()) return Error{path, message("has no value in the column \"{}\" to split by", map.split)};
  const size_t taken = std::min(static_cast<size_t>(std::max(part, 0)), tables->size() - 1);
  return settleTable(std::move((*tables)[taken]), map,
                     path + " (" + map.split + " " + parts[static_cast<int>(taken)].toStdString() + ")");
}

}  // namespace

LogOpening::LogOpening(Messages& messages, QObject* parent) : QObject(parent), messages_(messages) {
  pool_.setMaxThreadCount(1);
}

LogOpening::~LogOpening() {
  pool_.waitForDone();
}

bool LogOpening::isRecording(const QString& path) {
  if (isBlockFile(path.toStdString())) return true;
  QFile file(path);
  if (!path.endsWith(".csv") || !file.open(QIODevice::ReadOnly)) return !QFileInfo::exists(path);
  QByteArray line = file.readLine(1 << 20);
  while (line.startsWith('#')) line = file.readLine(1 << 20);
  return line.trimmed().split(',').contains("time_s");
}

QString LogOpening::memory() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + "/breakaway/imports";
}

QString LogOpening::memoryFile() const {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  for (const RawColumn& column : table_->table.columns)
    hash.addData(QByteArray::fromStdString(column.channel.name + "\n"));
  return memory() + "/" + hash.result().toHex().left(32) + ".map.json";
}

void LogOpening::open(const QString& path) {
  close();
  pool_.start([this, path, mine = wanted_] {
    auto read = readTable(path.toStdString());
    if (read) {
      if (const auto known = translateKnownLog(read->table, path.toStdString()); !known) read = known.error();
    }
    QMetaObject::invokeMethod(
        this,
        [this, mine, path, read] {
          if (mine != wanted_) return;
          if (!read) return messages_.warn(read.error());
          path_ = path;
          table_ = std::make_shared<const ReadTable>(*read);
          columns_ = bareColumns(table_->table);
          if (QFile::exists(memoryFile())) {
            const auto map = readImportMap(memoryFile().toStdString());
            map ? void(map_ = *map) : messages_.warn(map.error());
          }
          settle();
        },
        Qt::QueuedConnection);
  });
}

void LogOpening::close() {
  ++wanted_;
  settling_ = false;
  table_.reset();
  map_ = {};
  parts_.clear();
  part_ = 0;
  recording_.reset();
  columns_.clear();
  remarks_.clear();
  fault_ = {};
  emit changed();
}

void LogOpening::take(const QString& column, const QString& to, const QString& unit) {
  const std::string name = column.toStdString(), target = to.toStdString();
  if (!to.isEmpty()) std::erase_if(map_.columns, [&target](const auto& one) { return one.second.to == target; });
  ColumnRule rule{to.isEmpty() ? asideName(name) : target};
  if (!to.isEmpty()) rule.unit = unit.toStdString();
  map_.columns[name] = rule;
  settle();
}

void LogOpening::say(std::optional<double> ImportMap::*number, std::optional<double> value) {
  if (map_.*number == value) return;
  map_.*number = value;
  settle();
}

void LogOpening::splitBy(const QString& column) {
  if (map_.split == column.toStdString()) return;
  map_.split = column.toStdString();
  part_ = 0;
  settle();
}

void LogOpening::takePart(int part) {
  if (part_ == part) return;
  part_ = part;
  settle();
}

void LogOpening::guessAgain() {
  if (!isOpen()) return;
  QFile::remove(memoryFile());
  map_ = {};
  part_ = 0;
  settle();
}

void LogOpening::settle() {
  ++wanted_;
  settling_ = true;
  emit changed();
  pool_.start([this, mine = wanted_, table = table_, map = map_, path = path_.toStdString(), part = part_] {
    QStringList parts;
    const auto imported = settled(*table, map, path, part, parts);
    QMetaObject::invokeMethod(
        this, [this, mine, imported, parts] { mine == wanted_ ? show(imported, parts) : void(); },
        Qt::QueuedConnection);
  });
}

void LogOpening::show(const Result<Imported>& imported, const QStringList& parts) {
  settling_ = false;
  parts_ = parts;
  recording_.reset();
  remarks_.clear();
  fault_ = {};
  columns_ = bareColumns(table_->table);
  if (!imported) {
    fault_ = imported.error().said();
    for (LogColumn& column : columns_) {
      const auto rule = map_.columns.find(column.name.toStdString());
      if (rule == map_.columns.end() || columnNamed(rule->second.to) == nullptr) continue;
      column.to = QString::fromStdString(rule->second.to);
      column.unit = QString::fromStdString(rule->second.unit);
    }
  } else {
    recording_ = imported->recording;
    remarks_ = imported->remarks;
    for (size_t c = 0; c < std::min(columns_.size(), imported->columns.size()); ++c) {
      const ColumnFate& fate = imported->columns[c];
      LogColumn& column = columns_[c];
      if (fate.kind == ColumnFate::Kind::used) column.to = QString::fromStdString(fate.to);
      column.unit = QString::fromStdString(fate.unit == "SI" ? "" : fate.unit);
      column.why = fate.why;
      column.guessed = fate.guessed && fate.kind == ColumnFate::Kind::used;
    }
  }
  emit changed();
}

void LogOpening::accept() {
  if (!recording_ || settling_) return;
  if (!map_.empty()) {
    const auto made = makeFolder(memory().toStdString());
    const auto kept = made ? writeFile(memoryFile().toStdString(), importMapText(map_)) : made;
    if (!kept) messages_.warn(kept.error());
  }
  emit accepted(*recording_);
  close();
}

}  // namespace breakaway
