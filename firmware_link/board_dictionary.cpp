#include "firmware_link/board_dictionary.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "firmware_link/description_check.h"

namespace breakaway {

namespace {

std::uint32_t wordOf(const BoardParameter& parameter, double value) {
  if (parameter.format == wire::Format::uint32) return static_cast<std::uint32_t>(std::llround(std::max(0.0, value)));
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

double valueOf(const BoardParameter& parameter, std::uint32_t word) {
  return parameter.format == wire::Format::uint32 ? static_cast<double>(word)
                                                  : static_cast<double>(std::bit_cast<float>(word));
}

/// Why nobody answered, from what came instead.
Error noAnswer(const BoardLink& link, const Error& error) {
  const wire::FrameCounts& counts = link.counts();
  if (counts.otherVersion > 0)
    return {link.place(), "speaks another version of the wire, expected version " + std::to_string(wire::version)};
  if (counts.errors() > 0)
    return {link.place(),
            "sends bytes that are no frames of the wire; is it another kind of board, or is the baud rate another?"};
  return {link.place(), error.fact + "; check power, cable and port, and that it is a board of this kind"};
}

}  // namespace

Result<BoardDictionary> BoardDictionary::read(BoardLink& link) {
  BoardDictionary dictionary;
  if (auto cleared = link.clear(); !cleared) return cleared.error();
  const auto hello = link.ask<wire::Hello>(wire::Type::hello, BoardLink::Patience{0.25, 6});
  if (!hello) return noAnswer(link, hello.error());
  dictionary.hello_ = *hello;
  const Error unusable{link.place(), "describes itself in a way that is none of the wire's, version 1"};
  if (auto checked = checkHello(link.place(), *hello); !checked) return checked.error();
  if (dictionary.can(wire::Hello::serialNumber)) {
    const auto serial = link.ask<wire::SerialNumber>(wire::Type::serialNumber, BoardLink::Patience{0.25, 6});
    if (!serial) return serial.error();
    dictionary.serial_ = *serial;
  }
  wire::Crc32c hash;
  for (std::size_t first = 0; first < hello->entries;) {
    const auto page = link.ask<wire::DictionaryPage>(
        wire::Type::dictionary, wire::DictionaryAsked{static_cast<std::uint16_t>(first)}, BoardLink::Patience{0.25, 6});
    if (!page) return page.error();
    if (page->count == 0 || page->first != first) return unusable;
    for (std::size_t k = 0; k < page->count; ++k) {
      const wire::DictionaryEntry& entry = page->entry[k];
      hash.add(bodyOf(entry));
      if (auto checked = checkEntry(link.place(), entry); !checked) return checked.error();
      if (entry.kind == wire::DictionaryEntry::Kind::parameter) {
        dictionary.parameters_.push_back({entry.id, textOf(entry.name), entry.format, entry.writable != 0,
                                          static_cast<double>(entry.least), static_cast<double>(entry.most)});
      } else if (entry.kind == wire::DictionaryEntry::Kind::channel && entry.id < wire::channelCount) {
        if (entry.format != wire::channelForms[entry.id].format) return unusable;
        dictionary.scale_[entry.id] = static_cast<double>(entry.scale);
      }
    }
    first += page->count;
  }
  if (hash.value() != hello->dictionaryHash)
    return Error{link.place(), message("gave a dictionary that is not the one it announced; connect again")};
  if (auto checked = dictionary.checkValues(link); !checked) return checked.error();
  return dictionary;
}

/// Every value is asked for once, so that none that is absurd comes to light in the middle of a job.
Result<void> BoardDictionary::checkValues(BoardLink& link) const {
  for (std::size_t k = 0; k < wire::channelCount; ++k) {
    const wire::ChannelForm& form = wire::channelForms[k];
    if (form.format == wire::Format::int16 && (wire::usualChannels >> k & 1u) != 0 && scale_[k] == 0.0)
      return Error{link.place(), message("says nothing of the channel {}", form.name)};
  }
  std::vector<std::string> names;
  names.reserve(parameters_.size());
  for (const BoardParameter& parameter : parameters_) names.push_back(parameter.name);
  const auto told = values(link, names);
  return told ? Result<void>{} : told.error();
}

std::string BoardDictionary::device() const {
  return textOf(hello_.device);
}

std::string BoardDictionary::firmware() const {
  return textOf(hello_.firmware);
}

std::string BoardDictionary::serialNumber() const {
  return textOf(serial_.text);
}

const BoardParameter* BoardDictionary::find(const std::string& name) const {
  const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                  [&name](const BoardParameter& one) { return one.name == name; });
  return found == parameters_.end() ? nullptr : &*found;
}

SampleDecoder::Board BoardDictionary::telemetry() const {
  SampleDecoder::Board board;
  board.loopRate_Hz = static_cast<double>(hello_.loopRate_Hz);
  board.countsPerRev = static_cast<double>(hello_.countsPerRev);
  board.supply_V = static_cast<double>(hello_.supply_V);
  std::copy(std::begin(scale_), std::end(scale_), std::begin(board.scale));
  return board;
}

Result<std::vector<double>> BoardDictionary::exchange(BoardLink& link, wire::Type type,
                                                      const std::vector<std::pair<std::string, double>>& values) const {
  std::vector<double> answered;
  for (std::size_t from = 0; from < values.size(); from += wire::ParameterList::mostValues) {
    wire::ParameterList list;
    for (std::size_t k = from; k < values.size() && list.count < wire::ParameterList::mostValues; ++k) {
      const BoardParameter* parameter = find(values[k].first);
      if (parameter == nullptr) return Error{link.place(), message("has no parameter {}", values[k].first)};
      list.value[list.count++] = {parameter->id, wordOf(*parameter, values[k].second)};
    }
    const auto answer = link.ask<wire::ParameterList>(type, list);
    if (!answer) return answer.error();
    if (answer->count != list.count)
      return Error{link.place(), message("answered with other parameters than were asked for")};
    for (std::size_t k = 0; k < list.count; ++k) {
      const std::string& name = values[from + k].first;
      answered.push_back(valueOf(*find(name), answer->value[k].word));
      if (auto checked = checkValue(link.place(), name, answered.back()); !checked) return checked.error();
    }
  }
  return answered;
}

Result<std::vector<double>> BoardDictionary::values(BoardLink& link, const std::vector<std::string>& names) const {
  std::vector<std::pair<std::string, double>> asked;
  asked.reserve(names.size());
  for (const std::string& name : names) asked.emplace_back(name, 0.0);
  return exchange(link, wire::Type::readParameters, asked);
}

Result<std::vector<double>> BoardDictionary::write(BoardLink& link,
                                                   const std::vector<std::pair<std::string, double>>& wanted) const {
  return exchange(link, wire::Type::writeParameters, wanted);
}

}  // namespace breakaway
