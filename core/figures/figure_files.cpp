#include "figures/figure_files.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/exact_text.h"
#include "base/made.h"
#include "draw/html_report.h"
#include "draw/png.h"

namespace breakaway {

namespace {

constexpr int square_px = 560;

struct Size {
  int width_px, height_px;
};

/// Square where both axes are alike.
Size sizeOf(const Figure& figure) {
  return figure.polar || figure.equalScale ? Size{square_px, square_px} : Size{860, 380};
}

Result<std::string> csvOf(const BenchFigure& figure) {
  std::string text;
  for (const Channel& one : figure.columns) text += (text.empty() ? "" : ",") + one.name;
  text += '\n';
  const size_t rows = figure.columns.empty() ? 0 : figure.columns.front().values.size();
  for (const Channel& one : figure.columns) {
    if (one.values.size() != rows) return Error{figure.name, "column " + one.name + " is not as long as the others"};
  }
  for (size_t row = 0; row < rows; ++row) {
    for (size_t k = 0; k < figure.columns.size(); ++k) {
      const double value = figure.columns[k].values[row];
      if (!std::isfinite(value))
        return Error{figure.name,
                     "column " + figure.columns[k].name + " has no number in row " + std::to_string(row + 1)};
      text += (k == 0 ? "" : ",") + exactText(value);
    }
    text += '\n';
  }
  return text;
}

std::string indexHtml(const std::vector<BenchFigure>& figures) {
  HtmlReport report("Figures of the bench", "measured through the drive port on simulated boards");
  for (const BenchFigure& one : figures) {
    report.heading(one.figure.title);
    const Size size = sizeOf(one.figure);
    report.figure(one.figure, one.says, size.width_px, size.height_px);
    std::vector<std::pair<Saying, Saying>> facts;
    facts.reserve(one.keyNumbers.size());
    for (const auto& [name, value] : one.keyNumbers) facts.emplace_back(name, numberText(value));
    report.facts(facts);
    report.paragraph("Files: " + one.name + ".svg, " + one.name + ".png, " + one.name + ".csv");
  }
  return report.html();
}

nlohmann::ordered_json indexJson(const std::vector<BenchFigure>& figures) {
  nlohmann::ordered_json index{{"schema", "breakaway.figures/1"}, {"figures", nlohmann::ordered_json::array()}};
  for (const BenchFigure& one : figures) {
    nlohmann::ordered_json numbers = nlohmann::ordered_json::object();
    for (const auto& [name, value] : one.keyNumbers) numbers[name] = value;
    index["figures"].push_back({{"name", one.name},
                                {"title", one.figure.title},
                                {"says", one.says},
                                {"numbers", numbers},
                                {"svg", one.name + ".svg"},
                                {"png", one.name + ".png"},
                                {"csv", one.name + ".csv"}});
  }
  return index;
}

}  // namespace

Result<void> writeFigures(const std::vector<BenchFigure>& figures, const std::string& folder) {
  std::vector<std::string> tables;
  for (const BenchFigure& one : figures) {
    auto table = csvOf(one);
    if (!table) return table.error();
    tables.push_back(std::move(*table));
  }
  if (auto made = makeFolder(folder); !made) return made;
  for (size_t k = 0; k < figures.size(); ++k) {
    const std::string path = folder + "/" + figures[k].name;
    const Size size = sizeOf(figures[k].figure);
    auto drawn = writeSvg(figures[k].figure, path + ".svg", size.width_px, size.height_px);
    if (!drawn) return drawn;
    if (auto converted = convertToPng(path + ".svg", path + ".png"); !converted) return converted;
    if (auto written = writeFile(path + ".csv", tables[k]); !written) return written;
  }
  if (auto written = writeFile(folder + "/figures.json", withMade(indexJson(figures).dump(2) + "\n")); !written)
    return written;
  return writeFile(folder + "/index.html", indexHtml(figures));
}

}  // namespace breakaway
