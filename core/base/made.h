// Where a file comes from: what every JSON, report and figure says of the run that made it (files.md#made).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace breakaway {

/// A file that was read, and the SHA-256 of what was read, in hexadecimal.
struct InputFile {
  std::string path, sha256;
  bool operator==(const InputFile&) const = default;
};

/// The board that was measured.
struct MadeOn {
  std::string model, serialNumber, firmware;
  bool operator==(const MadeOn&) const = default;
};

/// One run of a program. Empty texts and what has no value are null in files.
struct Made {
  std::string at;       ///< when the run began: UTC, ISO 8601, to the second
  std::string by;       ///< program and version
  std::string command;  ///< its words, as a shell takes them
  std::optional<std::uint64_t> seed = {};
  std::vector<InputFile> inputs = {};
  std::optional<MadeOn> device = {};
  std::optional<double> rigTime_s = {};  ///< the board's clock when the measurement ended
  std::string run;                       ///< an identifier of this run, a UUID
};

/// Begins the run of this process: from here on, files that are read are its inputs. `by` and `command` as in Made.
void beginRun(std::string by, std::string command, std::optional<std::uint64_t> seed = {});

/// The run of this process with what it has read and measured so far. Without beginRun() a run of nobody's, without
/// inputs. From any thread.
Made thisRun();

/// Notes that `content` was read from `path`, for a run that has begun.
void noteInput(const std::string& path, std::string_view content);

/// What is read from `folder` from here on counts as read from `name`: that is where it will be put.
void nameFolder(const std::string& folder, const std::string& name);

/// Notes the board that is measured, for a run that has begun; nothing: none is.
void noteDevice(std::optional<MadeOn> device);

/// Notes the board's clock at the end of a measurement, for a run that has begun.
void noteRigTime(double time_s);

/// While this lives, what its thread reads is an input of what its thread writes alone, as for one of many jobs.
class OwnInputs {
 public:
  OwnInputs();
  ~OwnInputs();
  OwnInputs(const OwnInputs&) = delete;
  OwnInputs& operator=(const OwnInputs&) = delete;

 private:
  std::vector<InputFile> inputs_;
  std::vector<InputFile>* before_;
};

/// SHA-256 (FIPS 180-4) in hexadecimal.
std::string sha256Of(std::string_view content);

/// thisRun() as a JSON object in one line.
std::string madeJson();

/// The JSON object `text` with `made` as its last field. `text` ends with its brace, maybe a line's end after it.
std::string withMade(std::string text);

/// The SVG document with madeJson() in a `metadata` element at its end.
std::string svgWithMade(std::string svg);

/// For the end of an HTML page: a line for people, and madeJson() folded away in the element `made`.
std::string htmlOfMade();

/// `words` as one line that a shell takes apart into the same.
std::string asCommand(const std::vector<std::string>& words);

}  // namespace breakaway
