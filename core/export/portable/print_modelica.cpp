#include <algorithm>

#include "base/exact_text.h"
#include "export/portable/print.h"
#include "export/portable/printer.h"

namespace breakaway {

namespace {

/// Text between Modelica's quotation marks.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

class Modelica final : public Printer {
 public:
  using Printer::Printer;

  std::string whole() const {
    std::string out = lines(program().head, 0) + "package " + program().name + "\n";
    for (const Constant& one : program().constants)
      out += "  constant Real " + one.name + " = " + exactText(one.value) + described(one.comment) + ";\n";
    out += "\n  record State\n";
    for (const Field& field : program().state)
      out += "    Real " + field.name + (field.size > 0 ? "[" + std::to_string(field.size) + "]" : "") +
             described(field.comment) + ";\n";
    out += "  end State;\n\n" + startText();
    for (const Function& one : program().functions) out += "\n" + functionText(one);
    return out + "\n" + sampledText() + "end " + program().name + ";\n";
  }

 private:
  static std::string described(const std::string& comment) { return comment.empty() ? "" : " " + quoted(comment); }

  std::string startText() const {
    const std::string place = program().state[0].name, speed = program().state[1].name;
    std::string out = "  // The state at the begin.\n  function start\n    input Real " + place +
                      " = 0.0;\n    input Real " + speed + " = 0.0;\n    output State s;\n  algorithm\n";
    for (const Field& field : program().state) {
      const std::string value = field.name == place || field.name == speed ? field.name : exactText(field.initial);
      out += "    s." + field.name +
             " := " + (field.size > 0 ? "fill(" + value + ", " + std::to_string(field.size) + ")" : value) + ";\n";
    }
    return out + "  end start;\n";
  }

  std::string functionText(const Function& one) const {
    std::string out = lines(one.comment, 1) + "  function " + one.name + "\n";
    if (one.state == Function::State::read) out += "    input State s;\n";
    if (one.state == Function::State::changed) out += "    input State before;\n";
    for (const std::string& name : one.arguments) out += "    input Real " + name + ";\n";
    if (one.state == Function::State::changed) out += "    output State s;\n";
    for (const std::string& name : one.outputs) out += "    output Real " + name + ";\n";
    const auto locals = one.locals();
    if (!locals.empty()) out += "  protected\n";
    for (const std::string& name : locals) out += "    Real " + name + ";\n";
    out += "  algorithm\n";
    if (one.state == Function::State::changed) out += "    s := before;\n";
    for (const std::string& name : one.outputs) out += "    " + name + " := 0.0;\n";
    return out + text(one.body, 2) + "  end " + one.name + ";\n";
  }

  /// The step as a block that whoever draws diagrams can wire.
  std::string sampledText() const {
    const Function* step = ownFunction("step");
    if (step == nullptr) return {};
    std::string out =
        "  // A step every dt_s, its inputs held meanwhile.\n  block Sampled\n    parameter Real dt_s = " +
        std::string("0.001;\n");
    std::string arguments;
    for (const std::string& name : step->arguments) {
      if (name != "dt_s") out += "    input Real " + name + ";\n";
      arguments += ", " + name;
    }
    const std::string place = program().state[0].name, speed = program().state[1].name;
    return out + "    output Real " + place + ";\n    output Real " + speed +
           ";\n    State s;\n  algorithm\n    when initial() then\n      s := start(0.0, 0.0);\n"
           "    elsewhen sample(dt_s, dt_s) then\n      s := step(s" +
           arguments + ");\n    end when;\n    " + place + " := s." + place + ";\n    " + speed + " := s." + speed +
           ";\n  end Sampled;\n";
  }

  std::string elementText(const std::string& array, const std::string& index) const override {
    return array + "[integer(" + index + ") + 1]";
  }
  std::string conditionalText(const std::string& condition, const std::string& then,
                              const std::string& otherwise) const override {
    return "(if " + condition + " then " + then + " else " + otherwise + ")";
  }
  std::string builtinText(const std::string& name, const std::vector<std::string>& arguments) const override {
    if (name == "pow") return "((" + arguments[0] + ") ^ (" + arguments[1] + "))";
    std::string out = name + "(";
    for (size_t k = 0; k < arguments.size(); ++k) out += (k > 0 ? ", " : "") + arguments[k];
    return out + ")";
  }
  std::string ownCallText(const Function& function, const Expression& call) const override {
    const std::string rest = argumentsOf(call);
    const bool state = function.state != Function::State::none;
    return function.name + "(" + (state ? rest.empty() ? "s" : "s, " : "") + rest + ")";
  }
  std::string operatorText(const std::string& sign) const override {
    return sign == "&&" ? "and" : sign == "||" ? "or" : sign == "!" ? "not " : sign == "!=" ? "<>" : sign;
  }
  std::string commentMark() const override { return "//"; }
  std::string assignText(const std::string& target, const std::string& value) const override {
    return target + " := " + value + ";";
  }
  std::string assignManyText(const std::vector<std::string>& targets, const Expression& call) const override {
    std::string out;
    for (const std::string& target : targets) out += (out.empty() ? "" : ", ") + target;
    return "(" + out + ") := " + ownCallText(*ownFunction(call.text), call) + ";";
  }
  std::string callText(const Function& function, const Expression& call) const override {
    return "s := " + ownCallText(function, call) + ";";
  }
  std::string ifText(const std::string& condition) const override { return "if " + condition + " then"; }
  std::string elseIfText(const std::string& condition) const override { return "elseif " + condition + " then"; }
  std::string elseText() const override { return "else"; }
  std::string whileText(const std::string& condition) const override { return "while " + condition + " loop"; }
  std::string endText(Statement::Kind of) const override {
    return of == Statement::Kind::loop ? "end while;" : "end if;";
  }
};

}  // namespace

std::string modelicaText(const Program& program) {
  return Modelica(program).whole();
}

}  // namespace breakaway
