#include <zip.h>

#include <algorithm>
#include <array>
#include <vector>

#include "fuzz/imported.h"
#include "recording/import/xlsx.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

/// Parts of the bytes, which lines of "%" divide, as the members of a workbook whose packing is sound.
std::string workbookOf(std::string_view bytes) {
  static constexpr std::array names{"xl/worksheets/sheet1.xml", "xl/sharedStrings.xml", "xl/styles.xml",
                                    "xl/workbook.xml", "xl/_rels/workbook.xml.rels"};
  zip_source_t* packed = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(packed);
  zip_t* archive = zip_open_from_source(packed, ZIP_TRUNCATE, nullptr);
  for (const char* name : names) {
    const size_t end = std::min(bytes.find("\n%\n"), bytes.size());
    zip_source_t* part = zip_source_buffer(archive, bytes.data(), end, 0);
    const auto index = zip_file_add(archive, name, part, ZIP_FL_OVERWRITE);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_STORE, 0);
    bytes.remove_prefix(std::min(end + 3, bytes.size()));
  }
  require(zip_close(archive) == 0, "the workbook can be packed");
  zip_source_open(packed);
  std::string content(65536 + bytes.size(), '\0');
  std::string whole;
  zip_int64_t got = 0;
  while ((got = zip_source_read(packed, content.data(), content.size())) > 0)
    whole.append(content, 0, static_cast<size_t>(got));
  zip_source_close(packed);
  zip_source_free(packed);
  return whole;
}

}  // namespace

/// A workbook whose XML is anything.
static const Fuzzed xlsx("xlsx", [](std::string_view bytes) {
  const std::string packed = workbookOf(bytes);
  const auto archive = ZipArchive::open(packed, "log");
  require(archive.ok(), "what was packed opens");
  requireSound(readWorkbook(*archive, "log"));
});
