#include "base/exact_text.h"
#include "export/portable/print.h"
#include "export/portable/printer.h"

namespace breakaway {

namespace {

class Python final : public Printer {
 public:
  using Printer::Printer;

  std::string whole() const {
    std::string out = lines(program().head, 0) + "import math\n\n";
    for (const Constant& one : program().constants)
      out += one.name + " = " + exactText(one.value) + (one.comment.empty() ? "" : "  # " + one.comment) + "\n";
    out += "\n\nclass State:\n";
    const std::string place = program().state[0].name, speed = program().state[1].name;
    out += "  def __init__(s, " + place + "=0.0, " + speed + "=0.0):\n";
    for (const Field& field : program().state) {
      const bool given = field.name == place || field.name == speed;
      const std::string value = given ? field.name : exactText(field.initial);
      out += "    s." + field.name + " = " +
             (field.size > 0 ? "[" + value + "] * " + std::to_string(field.size) : value) +
             (field.comment.empty() ? "" : "  # " + field.comment) + "\n";
    }
    for (const Function& one : program().functions) out += "\n\n" + functionText(one);
    out += "\n\n# The state at the begin.\ndef start(" + place + "=0.0, " + speed + "=0.0):\n  return State(" + place +
           ", " + speed + ")\n";
    return out;
  }

 private:
  std::string functionText(const Function& one) const {
    std::string arguments = one.state == Function::State::none ? "" : "s";
    for (const std::string& name : one.arguments) arguments += (arguments.empty() ? "" : ", ") + name;
    std::string outputs;
    for (const std::string& name : one.outputs) outputs += (outputs.empty() ? "" : ", ") + name;
    std::string out = lines(one.comment, 0) + "def " + one.name + "(" + arguments + "):\n";
    for (const std::string& name : one.outputs) out += "  " + name + " = 0.0\n";
    for (const std::string& name : one.locals()) out += "  " + name + " = 0.0\n";
    out += text(one.body, 1);
    if (!outputs.empty()) return out + "  return " + outputs + "\n";
    return out + "  return s\n";
  }

  std::string elementText(const std::string& array, const std::string& index) const override {
    return array + "[int(" + index + ")]";
  }
  std::string conditionalText(const std::string& condition, const std::string& then,
                              const std::string& otherwise) const override {
    return "(" + then + " if " + condition + " else " + otherwise + ")";
  }
  std::string builtinText(const std::string& name, const std::vector<std::string>& arguments) const override {
    std::string out = (name == "abs" || name == "min" || name == "max" ? "" : "math.") + name + "(";
    for (size_t k = 0; k < arguments.size(); ++k) out += (k > 0 ? ", " : "") + arguments[k];
    return out + ")";
  }
  std::string ownCallText(const Function& function, const Expression& call) const override {
    const std::string rest = argumentsOf(call);
    const bool state = function.state != Function::State::none;
    return function.name + "(" + (state ? rest.empty() ? "s" : "s, " : "") + rest + ")";
  }
  std::string operatorText(const std::string& sign) const override {
    return sign == "&&" ? "and" : sign == "||" ? "or" : sign == "!" ? "not " : sign;
  }
  std::string commentMark() const override { return "#"; }
  std::string assignText(const std::string& target, const std::string& value) const override {
    return target + " = " + value;
  }
  std::string assignManyText(const std::vector<std::string>& targets, const Expression& call) const override {
    std::string out;
    for (const std::string& target : targets) out += (out.empty() ? "" : ", ") + target;
    return out + " = " + ownCallText(*ownFunction(call.text), call);
  }
  std::string callText(const Function& function, const Expression& call) const override {
    return ownCallText(function, call);
  }
  std::string ifText(const std::string& condition) const override { return "if " + condition + ":"; }
  std::string elseIfText(const std::string& condition) const override { return "elif " + condition + ":"; }
  std::string elseText() const override { return "else:"; }
  std::string whileText(const std::string& condition) const override { return "while " + condition + ":"; }
  std::string endText(Statement::Kind) const override { return {}; }
  std::string stopText() const override { return "return s"; }
};

}  // namespace

std::string pythonText(const Program& program) {
  return Python(program).whole();
}

}  // namespace breakaway
