#include "recording/import/read_table.h"

#include <algorithm>

#include "base/atomic_file.h"
#include "recording/import/file_kind.h"
#include "recording/import/gzip.h"
#include "recording/import/hdf5_table.h"
#include "recording/import/json_log.h"
#include "recording/import/mat.h"
#include "recording/import/npy.h"
#include "recording/import/text_table.h"
#include "recording/import/wpilog.h"
#include "recording/import/xlsx.h"
#include "recording/import/zip_archive.h"

namespace breakaway {

namespace {

Result<ReadTable> whole(Result<RawTable> table) {
  if (!table) return table.error();
  return ReadTable{std::move(*table), {}};
}

/// A zip archive is a workbook, arrays, or one packed log.
Result<ReadTable> readZip(const std::string& bytes, const std::string& name) {
  const auto archive = ZipArchive::open(bytes, name);
  if (!archive) return archive.error();
  if (isWorkbook(*archive)) return whole(readWorkbook(*archive, name));
  if (isNpz(*archive)) return whole(readNpz(*archive, name));
  if (archive->has("content.xml"))
    return Error{name, message("is an OpenDocument spreadsheet (.ods); save the sheet as .xlsx or CSV")};
  if (archive->has("xl/workbook.bin"))
    return Error{name, message("is a binary Excel workbook (.xlsb); save it as .xlsx or CSV")};
  const auto members = archive->members();
  if (members.size() != 1)
    return Error{name, message("is a zip archive of {} files; unpack it and import one of them", members.size())};
  auto content = archive->read(members.front());
  if (!content) return content.error();
  if (isZip(*content) || isGzip(*content))
    return Error{name, message("is a packed file within a zip archive; unpack it first")};
  return readTableBytes(std::move(*content), name);
}

Result<RawTable> readMatTable(std::string_view bytes, const std::string& name) {
  auto channels = readMat(bytes, name);
  if (!channels) return channels.error();
  std::vector<RawColumn> columns;
  for (Channel& channel : *channels) columns.push_back({std::move(channel), {}});
  return tableOfColumns(std::move(columns), name);
}

/// A brace, or a bracket that holds a value and not a stamp or mark as terminals put it ("[ID:001] …", "[12.5] 1,2").
bool beginsAsJson(std::string_view text) {
  const size_t start = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (start == std::string_view::npos || (text[start] != '{' && text[start] != '[')) return false;
  if (text[start] == '{') return true;
  const size_t first = text.find_first_not_of(" \t\r\n", start + 1);
  if (first == std::string_view::npos || std::string_view("{[\"]").find(text[first]) != std::string_view::npos)
    return true;
  if (std::string_view("-0123456789tfnN").find(text[first]) == std::string_view::npos) return false;  // "[ms],…"
  const size_t lineEnd = std::min(text.find('\n', first), text.size());
  const size_t close = text.substr(0, lineEnd).find(']', first);
  if (close == std::string_view::npos) return true;
  const size_t behind = text.find_first_not_of(" \t\r", close + 1);
  return behind == std::string_view::npos || text[behind] == '\n' || text[behind] == ',' || text[behind] == ']';
}

}  // namespace

Result<ReadTable> readTableBytes(std::string&& bytes, const std::string& name) {
  if (isGzip(bytes)) {
    auto unpacked = unpackGzip(bytes, name);
    if (!unpacked) return unpacked.error();
    bytes = std::move(*unpacked);
  }
  if (isZip(bytes)) return readZip(bytes, name);
  if (isNpy(bytes)) {
    auto columns = readNpy(bytes, "column", name);
    if (!columns) return columns.error();
    return whole(tableOfColumns(std::move(*columns), name));
  }
  if (isHdf5(bytes)) return whole(readHdf5(bytes, name));
  if (bytes.starts_with("MATLAB ") || name.ends_with(".mat")) return whole(readMatTable(bytes, name));
  if (isWpilog(bytes)) return whole(readWpilog(bytes, name));
  if (const auto kind = unreadKind(bytes, name)) return Error{name, *kind};
  if (beginsAsJson(bytes)) return readJsonLog(bytes, name);
  return whole(readTextTable(bytes, name));
}

Result<ReadTable> readTable(const std::string& path) {
  auto content = readFile(path);
  if (!content) return content.error();
  return readTableBytes(std::move(*content), path);
}

}  // namespace breakaway
