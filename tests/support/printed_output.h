// What the manual prints below a command, held against what the command says.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace breakaway::test {

/// A figure may be off by this part, and by half of its last place more.
inline constexpr double figureTolerance = 0.03;

/// A line that is typed, and what it says; nothing where the page doesn't print that.
struct PrintedCommand {
  QString line;
  QStringList output;
};

/// What stands between two ``` of a page.
struct Block {
  QString language;   ///< the word after the first ```
  QStringList lines;  ///< one that ends with a backslash is joined with the next
};

inline std::vector<Block> blocksOf(const QString& page) {
  std::vector<Block> blocks;
  const QStringList parts = ("\n" + page).split("\n```");
  for (qsizetype k = 1; k < parts.size(); k += 2) {
    QString text = parts[k];
    QStringList lines = text.replace(QRegularExpression(" *\\\\\n *"), " ").split('\n');
    const QString language = lines.takeFirst();
    blocks.push_back({language, lines});
  }
  return blocks;
}

/// What is typed of a line of a block without a language: without what the line says of itself.
inline QString typedOf(const QString& line) {
  return line.section(" #", 0, 0).trimmed();
}

inline bool isRunHere(const QString& line) {
  static const QRegularExpression known(
      "^((build/release/bin/)?breakaway(?!.*/dev/pts/N)|breakaway-board|zcat|python3) ");
  return known.match(line).hasMatch();
}

/// The lines of a page's blocks that call the program, or others on its files. A block that begins with ```output is
/// what the command before it says.
inline std::vector<PrintedCommand> commandsOf(const QString& page) {
  std::vector<PrintedCommand> commands;
  for (const Block& block : blocksOf(page)) {
    if (block.language == "output" && !commands.empty()) commands.back().output = block.lines;
    if (!block.language.isEmpty()) continue;
    for (const QString& line : block.lines)
      if (isRunHere(line)) commands.push_back({typedOf(line), {}});
  }
  return commands;
}

inline bool sameFigure(const QString& printed, const QString& said) {
  const double a = printed.toDouble(), b = said.toDouble();
  const auto places = printed.contains('e', Qt::CaseInsensitive) ? 0 : printed.section('.', 1).size();
  const double last = printed.contains('e', Qt::CaseInsensitive) ? 0.0 : std::pow(10.0, -static_cast<double>(places));
  return std::abs(a - b) <= figureTolerance * std::max(std::abs(a), std::abs(b)) + 0.501 * last;
}

/// Words to the letter, figures within the tolerance, "…" for any words.
inline bool sameLine(const QString& printed, const QString& said) {
  static const QRegularExpression figure(R"((?<![\w.])-?\d+(\.\d+)?(e[-+]?\d+)?)");
  QString pattern;
  QStringList figures;
  const auto words = [](QString text) {
    return QRegularExpression::escape(text).replace(QRegularExpression::escape("…"), ".*");
  };
  qsizetype at = 0;
  const QString wanted = printed.simplified(), found = said.simplified();
  for (auto it = figure.globalMatch(wanted); it.hasNext();) {
    const auto match = it.next();
    pattern += words(wanted.mid(at, match.capturedStart() - at)) + R"((-?\d+(?:\.\d+)?(?:e[-+]?\d+)?))";
    figures << match.captured();
    at = match.capturedEnd();
  }
  const auto match = QRegularExpression("^" + pattern + words(wanted.mid(at)) + "$").match(found);
  if (!match.hasMatch()) return false;
  for (qsizetype k = 0; k < figures.size(); ++k)
    if (!sameFigure(figures[k], match.captured(static_cast<int>(k) + 1))) return false;
  return true;
}

/// Empty, or the first line that the command doesn't say. A line "…" stands for any number of lines.
inline QString notSaid(const QStringList& printed, const QString& said) {
  QStringList lines = said.split('\n');
  if (lines.last().isEmpty()) lines.removeLast();
  qsizetype at = 0;
  bool skips = false;
  for (const QString& line : printed) {
    if (line == "…") {
      skips = true;
      continue;
    }
    const qsizetype from = at;
    while (skips && at < lines.size() && !sameLine(line, lines[at])) ++at;
    if (at >= lines.size() || !sameLine(line, lines[at]))
      return "printed: " + line + "\nsaid: " + (from < lines.size() ? lines[from] : QString("nothing more"));
    ++at;
    skips = false;
  }
  return skips || at == lines.size() ? QString() : "not printed: " + lines[at];
}

}  // namespace breakaway::test
