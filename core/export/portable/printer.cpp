#include "export/portable/printer.h"

#include <algorithm>

namespace breakaway {

namespace {

using TokenKind = Expression::Kind;

int levelOf(const Expression& expression) {
  if (expression.kind == TokenKind::unary) return 5;
  if (expression.kind != TokenKind::binary) return 6;
  const std::string& sign = expression.text;
  if (sign == "||") return 0;
  if (sign == "&&") return 1;
  if (sign == "+" || sign == "-") return 3;
  return sign == "*" || sign == "/" ? 4 : 2;
}

}  // namespace

bool Printer::isConstant(const std::string& name) const {
  return std::any_of(program_.constants.begin(), program_.constants.end(),
                     [&name](const Constant& one) { return one.name == name; });
}

const Function* Printer::ownFunction(const std::string& name) const {
  const auto it = std::find_if(program_.functions.begin(), program_.functions.end(),
                               [&name](const Function& one) { return one.name == name; });
  return it == program_.functions.end() ? nullptr : &*it;
}

std::string Printer::lines(const std::vector<std::string>& comment, int depth) const {
  std::string out;
  for (const std::string& line : comment) {
    out += indent(depth) + commentMark() + (line.empty() ? "" : " " + line) + "\n";
  }
  return out;
}

std::string Printer::argumentsOf(const Expression& call) const {
  std::string out;
  for (const Expression& part : call.parts) {
    if (part.kind == TokenKind::name && part.text == "s") continue;
    out += (out.empty() ? "" : ", ") + text(part);
  }
  return out;
}

std::string Printer::operand(const Expression& expression, int level, bool right) const {
  const int own = levelOf(expression);
  // Compilers warn of && within ||, and of comparisons in a row.
  const bool apart = own < level || (own == level && (right || own == 2)) || (level == 0 && own == 1) ||
                     expression.kind == TokenKind::unary;
  return apart ? "(" + text(expression) + ")" : text(expression);
}

std::string Printer::text(const Expression& expression) const {
  const auto& parts = expression.parts;
  switch (expression.kind) {
    case TokenKind::number:
      return numberText(expression.text);
    case TokenKind::name:
      if (expression.text.starts_with("s.")) return stateName(expression.text.substr(2));
      return isConstant(expression.text) ? constantName(expression.text) : expression.text;
    case TokenKind::element:
      return elementText(stateName(expression.text.substr(2)), text(parts[0]));
    case TokenKind::unary:
      return operatorText(expression.text) + operand(parts[0], 5, true);
    case TokenKind::binary: {
      const int level = levelOf(expression);
      return operand(parts[0], level, false) + " " + operatorText(expression.text) + " " +
             operand(parts[1], level, true);
    }
    case TokenKind::conditional:
      return conditionalText(text(parts[0]), text(parts[1]), text(parts[2]));
    case TokenKind::call:
      break;
  }
  if (const Function* own = ownFunction(expression.text)) return ownCallText(*own, expression);
  std::vector<std::string> arguments;
  arguments.reserve(parts.size());
  for (const Expression& part : parts) arguments.push_back(text(part));
  return builtinText(expression.text, arguments);
}

std::string Printer::branchText(const Statement& one, int depth, bool chained) const {
  std::string out = indent(depth) + (chained ? elseIfText(text(one.value)) : ifText(text(one.value))) + "\n" +
                    text(one.body, depth + 1);
  if (one.otherwise.size() == 1 && one.otherwise[0].kind == Statement::Kind::branch)
    return out + branchText(one.otherwise[0], depth, true);
  if (!one.otherwise.empty()) out += indent(depth) + elseText() + "\n" + text(one.otherwise, depth + 1);
  const std::string end = endText(one.kind);
  return end.empty() ? out : out + indent(depth) + end + "\n";
}

std::string Printer::text(const Statements& block, int depth) const {
  std::string out;
  for (const Statement& one : block) {
    switch (one.kind) {
      case Statement::Kind::comment:
        out += lines({one.text}, depth);
        break;
      case Statement::Kind::stop:
        out += indent(depth) + stopText() + "\n";
        break;
      case Statement::Kind::call:
        out += indent(depth) + callText(*ownFunction(one.value.text), one.value) + "\n";
        break;
      case Statement::Kind::branch:
        out += branchText(one, depth, false);
        break;
      case Statement::Kind::loop: {
        out += indent(depth) + whileText(text(one.value)) + "\n" + text(one.body, depth + 1);
        if (const std::string end = endText(one.kind); !end.empty()) out += indent(depth) + end + "\n";
        break;
      }
      case Statement::Kind::assign: {
        if (one.targets.size() == 1) {
          out += indent(depth) + assignText(text(one.targets[0]), text(one.value)) + "\n";
          break;
        }
        std::vector<std::string> targets;
        targets.reserve(one.targets.size());
        for (const Expression& target : one.targets) targets.push_back(text(target));
        out += indent(depth) + assignManyText(targets, one.value) + "\n";
        break;
      }
    }
  }
  return out;
}

}  // namespace breakaway
