// A program that C, Python, MATLAB and Modelica can all say: numbers, one record of state, functions on both.
#pragma once

#include <string>
#include <vector>

namespace breakaway {

/// A number's text, a name ("drive", "s.velocity"), an element of an array in the state, an operator or a call.
struct Expression {
  enum class Kind { number, name, element, unary, binary, conditional, call };
  Kind kind = Kind::number;
  std::string text;                    ///< digits, name, array, operator or function
  std::vector<Expression> parts = {};  ///< index, operands (a conditional's: condition, then, else), arguments
};

struct Statement;
using Statements = std::vector<Statement>;

struct Statement {
  enum class Kind { assign, call, branch, loop, comment, stop };
  Kind kind = Kind::comment;
  std::vector<Expression> targets = {};  ///< of an assignment, several for a function of several outputs
  Expression value = {};                 ///< what is assigned, called, or asked by branch and loop
  Statements body = {}, otherwise = {};
  std::string text = {};  ///< of a comment
};

/// The state is the first argument "s", of a function that reads it or changes it.
struct Function {
  enum class State { none, read, changed };
  std::string name;
  std::vector<std::string> comment = {};
  State state = State::none;
  std::vector<std::string> arguments = {};  ///< without the state
  std::vector<std::string> outputs = {};
  Statements body = {};
  bool shown = false;  ///< for whoever uses the program, not only for other functions

  /// Names that the body assigns beside its outputs, in the order of the first assignment.
  std::vector<std::string> locals() const;
};

struct Constant {
  std::string name;
  double value = 0.0;
  std::string comment = {};
};

/// A number of the state, or an array of them.
struct Field {
  std::string name;
  double initial = 0.0;
  std::string comment = {};
  size_t size = 0;  ///< of an array, whose elements all begin as `initial`; 0: one number
};

struct Program {
  std::string name;                    ///< of prefix, class or package
  std::vector<std::string> head = {};  ///< what it is, line by line
  std::vector<Constant> constants = {};
  std::vector<Field> state = {};
  std::vector<Function> functions = {};  ///< each after those that it calls
};

/// Functions from the house's own notation, which reads like C: assignments, `if … else`, `while`, `return`, calls,
/// `condition ? a : b`, and
///   /// what it is for
///   function NAME(ARGUMENTS) -> OUTPUT, … { … }
/// with the state as first argument `s`, or `&s` where it is changed; `shown` before `function` where people call it.
/// Operators: + - * / < <= > >= == != && || - !; conditions stand only where conditions are asked for.
/// Precondition: the text is right.
std::vector<Function> functionsIn(const std::string& text);

/// `text` with identifiers replaced: each pair is one and what stands for it. One that begins with a point is a field
/// of the state.
std::string renamed(const std::string& text, const std::vector<std::pair<std::string, std::string>>& names);

/// Those of `functions` that the shown ones call, directly or not, each once and after those that it calls.
std::vector<Function> needed(const std::vector<Function>& functions);

/// Whether `text` could be a name in all the languages: letters, digits and _, a letter first.
bool isIdentifier(const std::string& text);

}  // namespace breakaway
