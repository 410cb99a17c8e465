#include "base/exact_text.h"
#include "export/portable/print.h"
#include "export/portable/printer.h"

namespace breakaway {

namespace {

class Matlab final : public Printer {
 public:
  using Printer::Printer;

  std::string whole() const {
    std::string out = "classdef " + program().name + "\n" + lines(program().head, 1) + "\n  properties (Constant)\n";
    for (const Constant& one : program().constants)
      out += "    " + one.name + " = " + exactText(one.value) + ";" + (one.comment.empty() ? "" : " % " + one.comment) +
             "\n";
    out += "  end\n\n  methods (Static)\n" + startText();
    for (const Function& one : program().functions) out += "\n" + functionText(one);
    return out +
           "\n    % One of two numbers.\n    function value = pick(condition, yes, no)\n      if condition\n"
           "        value = yes;\n      else\n        value = no;\n      end\n    end\n  end\nend\n";
  }

 private:
  std::string startText() const {
    const std::string place = program().state[0].name, speed = program().state[1].name;
    std::string out = "    % The state at the begin.\n    function s = start(" + place + ", " + speed + ")\n";
    for (const Field& field : program().state) {
      const std::string value = field.name == place || field.name == speed ? field.name : exactText(field.initial);
      out += "      s." + field.name + " = " +
             (field.size > 0 ? "repmat(" + value + ", 1, " + std::to_string(field.size) + ")" : value) + ";" +
             (field.comment.empty() ? "" : " % " + field.comment) + "\n";
    }
    return out + "    end\n";
  }

  std::string functionText(const Function& one) const {
    std::string arguments = one.state == Function::State::none ? "" : "s", outputs;
    for (const std::string& name : one.arguments) arguments += (arguments.empty() ? "" : ", ") + name;
    for (const std::string& name : one.outputs) outputs += (outputs.empty() ? "" : ", ") + name;
    if (one.state == Function::State::changed) outputs = "s";
    if (one.outputs.size() > 1) outputs = "[" + outputs + "]";
    std::string out = lines(one.comment, 2) + "    function " + outputs + " = " + one.name + "(" + arguments + ")\n";
    for (const std::string& name : one.outputs) out += "      " + name + " = 0;\n";
    return out + text(one.body, 3) + "    end\n";
  }

  std::string constantName(const std::string& name) const override { return program().name + "." + name; }
  std::string elementText(const std::string& array, const std::string& index) const override {
    return array + "(" + index + " + 1)";
  }
  std::string conditionalText(const std::string& condition, const std::string& then,
                              const std::string& otherwise) const override {
    return program().name + ".pick(" + condition + ", " + then + ", " + otherwise + ")";
  }
  std::string builtinText(const std::string& name, const std::vector<std::string>& arguments) const override {
    std::string out = (name == "pow" ? "power" : name) + "(";
    for (size_t k = 0; k < arguments.size(); ++k) out += (k > 0 ? ", " : "") + arguments[k];
    return out + ")";
  }
  std::string ownCallText(const Function& function, const Expression& call) const override {
    const std::string rest = argumentsOf(call);
    const bool state = function.state != Function::State::none;
    return program().name + "." + function.name + "(" + (state ? rest.empty() ? "s" : "s, " : "") + rest + ")";
  }
  std::string operatorText(const std::string& sign) const override {
    return sign == "!=" ? "~=" : sign == "!" ? "~" : sign;
  }
  std::string commentMark() const override { return "%"; }
  std::string assignManyText(const std::vector<std::string>& targets, const Expression& call) const override {
    std::string out;
    for (const std::string& target : targets) out += (out.empty() ? "" : ", ") + target;
    return "[" + out + "] = " + ownCallText(*ownFunction(call.text), call) + ";";
  }
  std::string callText(const Function& function, const Expression& call) const override {
    return "s = " + ownCallText(function, call) + ";";
  }
  std::string ifText(const std::string& condition) const override { return "if " + condition; }
  std::string elseIfText(const std::string& condition) const override { return "elseif " + condition; }
  std::string elseText() const override { return "else"; }
  std::string whileText(const std::string& condition) const override { return "while " + condition; }
  std::string endText(Statement::Kind) const override { return "end"; }
};

}  // namespace

std::string matlabText(const Program& program) {
  return Matlab(program).whole();
}

}  // namespace breakaway
