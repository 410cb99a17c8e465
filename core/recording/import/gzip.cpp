#include "recording/import/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <climits>

namespace breakaway {

namespace {

constexpr size_t mostBytes = size_t{1} << 30;

/// Ends the stream whatever happens.
struct Stream : z_stream {
  Stream() : z_stream{} {}
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { inflateEnd(this); }
};

}  // namespace

bool isGzip(std::string_view bytes) {
  return bytes.size() > 18 && bytes[0] == '\x1F' && bytes[1] == '\x8B' && bytes[2] == '\x08';
}

Result<std::string> unpackGzip(std::string_view bytes, const std::string& name) {
  std::string content;
  while (isGzip(bytes)) {
    Stream stream;
    if (inflateInit2(&stream, 15 + 16) != Z_OK) return Error{name, message("can't be unpacked: zlib has no memory")};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(std::min<size_t>(bytes.size(), UINT_MAX));
    int state = Z_OK;
    size_t used = content.size();
    while (state == Z_OK) {
      if (used == content.size()) content.resize(std::min(mostBytes, used + std::max<size_t>(65536, used)));
      const size_t room = content.size() - used;
      if (room == 0) return Error{name, message("unpacks to more than 1 GB; unpack it first")};
      stream.next_out = reinterpret_cast<Bytef*>(content.data() + used);
      stream.avail_out = static_cast<uInt>(std::min<size_t>(room, UINT_MAX));
      state = inflate(&stream, Z_NO_FLUSH);
      used = static_cast<size_t>(reinterpret_cast<char*>(stream.next_out) - content.data());
      if (state == Z_BUF_ERROR && stream.avail_out == 0) state = Z_OK;
    }
    content.resize(used);
    if (state == Z_BUF_ERROR || (state == Z_OK && stream.avail_in == 0))
      return Error{name, message("is cut short: gzip's end is missing")};
    if (state != Z_STREAM_END) return Error{name, message("is damaged: gzip's content can't be unpacked")};
    bytes.remove_prefix(bytes.size() - stream.avail_in);
  }
  return content;
}

bool isDamagedZlib(std::string_view bytes) {
  Stream stream;
  if (bytes.size() > UINT_MAX || inflateInit(&stream) != Z_OK) return false;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string content(65536, '\0');
  int state = Z_OK;
  while (state == Z_OK && stream.total_out < mostBytes) {
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(content.size());
    state = inflate(&stream, Z_NO_FLUSH);
  }
  return state == Z_DATA_ERROR || state == Z_NEED_DICT;  // some writers leave the end out
}

}  // namespace breakaway
