#include "recording/import/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace breakaway {

namespace {

constexpr size_t mostEntryBytes = size_t{1} << 30;

zip_t* zipOf(void* archive) {
  return static_cast<zip_t*>(archive);
}

}  // namespace

bool isZip(std::string_view bytes) {
  return bytes.starts_with(std::string_view("PK\x03\x04", 4)) || bytes.starts_with(std::string_view("PK\x05\x06", 4));
}

Result<ZipArchive> ZipArchive::open(std::string_view bytes, const std::string& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  if (archive == nullptr) return Error{name, message("is a damaged zip archive, or one that is cut short")};
  return ZipArchive(archive, name);
}

ZipArchive::ZipArchive(ZipArchive&& other) noexcept
    : archive_(std::exchange(other.archive_, nullptr)), name_(std::move(other.name_)) {
}

ZipArchive::~ZipArchive() {
  if (archive_ != nullptr) zip_discard(zipOf(archive_));
}

std::vector<std::string> ZipArchive::members() const {
  std::vector<std::string> names;
  const auto count = zip_get_num_entries(zipOf(archive_), 0);
  for (zip_int64_t k = 0; k < count; ++k) {
    if (const char* name = zip_get_name(zipOf(archive_), static_cast<zip_uint64_t>(k), 0)) names.emplace_back(name);
  }
  return names;
}

bool ZipArchive::has(const std::string& member) const {
  return zip_name_locate(zipOf(archive_), member.c_str(), 0) >= 0;
}

Result<std::string> ZipArchive::read(const std::string& member) const {
  const std::string place = name_ + ", " + member;
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen(zipOf(archive_), member.c_str(), 0),
                                                               &zip_fclose);
  if (!file) return Error{place, message("can't be unpacked: it is missing, damaged or encrypted")};
  std::string content;
  size_t used = 0;
  while (true) {
    const size_t most = mostEntryBytes - unpacked_;
    if (used == content.size()) content.resize(std::min(most, used + std::max<size_t>(65536, used)));
    if (used == content.size()) return Error{place, message("unpacks to more than 1 GB; unpack the archive first")};
    const zip_int64_t got = zip_fread(file.get(), content.data() + used, content.size() - used);
    if (got < 0) return Error{place, message("is damaged and can't be unpacked")};
    if (got == 0) break;
    used += static_cast<size_t>(got);
  }
  content.resize(used);
  unpacked_ += used;
  return content;
}

}  // namespace breakaway
