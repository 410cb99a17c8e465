#include "recording/import/file_kind.h"

#include <array>

#include "base/marked_text.h"

namespace breakaway {

namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view magic;
  size_t at;
  MessageText<0> what;
};

constexpr auto kinds = std::to_array<Kind>({
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, 0,
     marked("is an Office file from before 2007 (.xls); save the sheet as .xlsx or CSV in Excel or LibreOffice")},
    {"\x89MCAP0\r\n"sv, 0, marked("is an MCAP log; PlotJuggler or Foxglove export it as CSV")},
    {"#ROSBAG V"sv, 0, marked("is a ROS bag; `rostopic echo -b FILE -p TOPIC > log.csv` or PlotJuggler converts it")},
    {"SQLite format 3\0"sv, 0,
     marked("is an SQLite file, such as a ROS 2 bag; PlotJuggler exports it as CSV, or `ros2 bag convert` as another "
            "bag")},
    {"PAR1"sv, 0, marked("is a Parquet file; in Python: pandas.read_parquet(FILE).to_csv(\"log.csv\")")},
    {"ARROW1"sv, 0, marked("is an Arrow or Feather file; in Python: pandas.read_feather(FILE).to_csv(\"log.csv\")")},
    {"FEA1"sv, 0, marked("is a Feather file; in Python: pandas.read_feather(FILE).to_csv(\"log.csv\")")},
    {"TDSm"sv, 0,
     marked("is a TDMS file; LabVIEW or Excel's TDM importer export it, in Python: nptdms' as_dataframe().to_csv()")},
    {"H Product:Blackbox"sv, 0, marked("is a Betaflight blackbox log; blackbox_decode makes a CSV of it")},
    {"MDF     "sv, 0, marked("is an MDF (.mf4) measurement; in Python: asammdf.MDF(FILE).export(\"csv\")")},
    {"UnFinMF "sv, 0, marked("is an unfinished MDF (.mf4) measurement; in Python: asammdf.MDF(FILE).export(\"csv\")")},
    {"ULog\x01\x12\x35"sv, 0, marked("is a PX4 ULog; ulog2csv converts it")},
    {"\xA3\x95"sv, 0, marked("is an ArduPilot DataFlash log; mavlogdump.py --format csv converts it")},
    {"SIMPLE  ="sv, 0, marked("is a FITS file, not a log that import reads; save it as CSV")},
    {"RIFF"sv, 0, marked("is a RIFF file, such as a sound (.wav); save its samples as CSV or .npy")},
    {"\x28\xB5\x2F\xFD"sv, 0, marked("is compressed by Zstandard; unzstd unpacks it")},
    {"\xFD"
     "7zXZ\0"sv,
     0, marked("is compressed by xz; unxz unpacks it")},
    {"BZh"sv, 0, marked("is compressed by bzip2; bunzip2 unpacks it")},
    {"7z\xBC\xAF\x27\x1C"sv, 0, marked("is a 7-Zip archive; unpack it first")},
    {"Rar!"sv, 0, marked("is a RAR archive; unpack it first")},
    {"ustar"sv, 257, marked("is a tar archive; unpack it first")},
    {"%PDF-"sv, 0, marked("is a PDF document; the numbers must come as CSV")},
    {"\x89PNG"sv, 0, marked("is a picture (PNG)")},
    {"\xFF\xD8\xFF"sv, 0, marked("is a picture (JPEG)")},
    {"GIF8"sv, 0, marked("is a picture (GIF)")},
    {"\x7F"
     "ELF"sv,
     0, marked("is a program")},
    {"<?xml"sv, 0, marked("is an XML file; export its table as CSV or .xlsx")},
    {"<html"sv, 0, marked("is a web page; export its table as CSV")},
    {"<!DOCTYPE"sv, 0, marked("is a web page; export its table as CSV")},
    {"RDX2\n"sv, 0, marked("is an R data file; in R: write.csv(x, \"log.csv\")")},
    {"RDX3\n"sv, 0, marked("is an R data file; in R: write.csv(x, \"log.csv\")")},
    {"version https://git-lfs"sv, 0, marked("is only a pointer of Git LFS; fetch the file itself with `git lfs pull`")},
});

/// Pickles begin with their protocol's number and end with a stop.
bool isPickle(std::string_view bytes) {
  return bytes.size() > 3 && bytes[0] == '\x80' && bytes[1] >= 2 && bytes[1] <= 5 && bytes.back() == '.';
}

}  // namespace

std::optional<Message> unreadKind(std::string_view bytes, std::string_view name) {
  for (const Kind& kind : kinds) {
    if (bytes.size() < kind.at + kind.magic.size()) continue;
    if (kind.magic == "BZh"sv && (bytes.size() < 10 || bytes.substr(4, 2) != "1A"sv)) continue;
    if (bytes.substr(kind.at, kind.magic.size()) == kind.magic) return message(kind.what);
  }
  if (isPickle(bytes)) return message("is a Python pickle; in Python: pandas.read_pickle(FILE).to_csv(\"log.csv\")");
  if (name.ends_with(".bbl") || name.ends_with(".bfl"))
    return message("is a blackbox log; blackbox_decode makes a CSV of it");
  size_t strange = 0;
  const std::string_view head = bytes.substr(0, 4000);
  for (const char c : head) strange += static_cast<unsigned char>(c) < 9 || (c > 13 && c < 32 && c != 27) ? 1 : 0;
  const bool wide =
      bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) ||
      (bytes.size() > 3 && (bytes[1] == '\0') != (bytes[0] == '\0') && (bytes[3] == '\0') != (bytes[2] == '\0'));
  if (!wide && 20 * strange > head.size())
    return message("is a binary file of a kind that import doesn't know; export it as CSV");
  return std::nullopt;
}

}  // namespace breakaway
