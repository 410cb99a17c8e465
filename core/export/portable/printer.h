// What printing a program has in common in all languages.
#pragma once

#include <string>
#include <vector>

#include "export/portable/program.h"

namespace breakaway {

/// Prints expressions and statements; a language says what it writes otherwise.
class Printer {
 public:
  explicit Printer(const Program& program) : program_(program) {}
  virtual ~Printer() = default;

 protected:
  const Program& program() const { return program_; }
  bool isConstant(const std::string& name) const;
  const Function* ownFunction(const std::string& name) const;

  std::string text(const Expression& expression) const;
  /// Each line of the block, `depth` steps in.
  std::string text(const Statements& block, int depth) const;
  static std::string indent(int depth) { return std::string(static_cast<size_t>(depth) * 2, ' '); }
  std::string lines(const std::vector<std::string>& comment, int depth) const;
  std::string argumentsOf(const Expression& call) const;

  virtual std::string numberText(const std::string& digits) const { return digits; }
  virtual std::string constantName(const std::string& name) const { return name; }
  virtual std::string stateName(const std::string& field) const { return "s." + field; }
  virtual std::string elementText(const std::string& array, const std::string& index) const = 0;
  virtual std::string conditionalText(const std::string& condition, const std::string& then,
                                      const std::string& otherwise) const = 0;
  /// A function that every language brings along: sin, exp, abs, min, …
  virtual std::string builtinText(const std::string& name, const std::vector<std::string>& arguments) const = 0;
  virtual std::string ownCallText(const Function& function, const Expression& call) const = 0;
  virtual std::string operatorText(const std::string& sign) const { return sign; }

  virtual std::string commentMark() const = 0;
  virtual std::string assignText(const std::string& target, const std::string& value) const {
    return target + " = " + value + ";";
  }
  virtual std::string assignManyText(const std::vector<std::string>& targets, const Expression& call) const = 0;
  virtual std::string callText(const Function& function, const Expression& call) const = 0;
  virtual std::string ifText(const std::string& condition) const = 0;
  virtual std::string elseIfText(const std::string& condition) const = 0;
  virtual std::string elseText() const = 0;
  virtual std::string whileText(const std::string& condition) const = 0;
  virtual std::string endText(Statement::Kind of) const = 0;  ///< empty: none is written
  virtual std::string stopText() const { return "return;"; }

 private:
  std::string operand(const Expression& expression, int level, bool right) const;
  std::string branchText(const Statement& statement, int depth, bool chained) const;

  const Program& program_;
};

}  // namespace breakaway
