#include <map>

#include "base/exact_text.h"
#include "export/portable/print.h"
#include "export/portable/printer.h"

namespace breakaway {

namespace {

std::string withPoint(const std::string& digits) {
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
  return out;
}

class C final : public Printer {
 public:
  using Printer::Printer;

  std::string whole() const {
    std::string guard = program().name + "_H";
    for (char& c : guard) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    std::string out = "/*\n";
    for (const std::string& line : program().head) out += line.empty() ? " *\n" : " * " + line + "\n";
    out += " */\n#ifndef " + guard + "\n#define " + guard + "\n\n#include <math.h>\n\n";
    std::string functions;
    for (const Function& one : program().functions) functions += functionText(one) + "\n";
    for (const Constant& one : program().constants) out += constantText(one, functions);
    out += "\ntypedef struct {\n";
    for (const Field& field : program().state)
      out += "  double " + field.name + (field.size > 0 ? "[" + std::to_string(field.size) + "]" : "") + ";" +
             (field.comment.empty() ? "" : " /* " + field.comment + " */") + "\n";
    return out + "} " + stateType() + ";\n\n" + functions + startText() + "\n#endif\n";
  }

 private:
  std::string stateType() const { return program().name + "_state"; }
  std::string called(const std::string& name) const { return program().name + "_" + name; }

  /// Compilers warn of a constant that no function asks for: such a one is told in a comment.
  std::string constantText(const Constant& one, const std::string& functions) const {
    const std::string name = constantName(one.name), value = name + " = " + withPoint(exactText(one.value));
    if (renamed(functions, {{name, ""}}) == functions)
      return "/* " + value + ", not needed here" + (one.comment.empty() ? "" : "; " + one.comment) + " */\n";
    return "static const double " + value + ";" + (one.comment.empty() ? "" : " /* " + one.comment + " */") + "\n";
  }

  std::string functionText(const Function& one) const {
    std::vector<std::string> arguments;
    if (one.state == Function::State::read) arguments.push_back("const " + stateType() + " *s");
    if (one.state == Function::State::changed) arguments.push_back(stateType() + " *s");
    for (const std::string& name : one.arguments) arguments.push_back("double " + name);
    const bool many = one.outputs.size() > 1;
    if (many) {
      for (const std::string& name : one.outputs) arguments.push_back("double *" + name + "_out");
    }
    std::string out = lines(one.comment, 0) + "static inline " + (one.outputs.size() == 1 ? "double " : "void ") +
                      called(one.name) + "(" + joined(arguments) + ") {\n";
    for (const std::string& name : one.outputs) out += "  double " + name + " = 0.0;\n";
    for (const std::string& name : one.locals()) out += "  double " + name + " = 0.0;\n";
    const std::string body = text(one.body, 1);
    const auto isUsed = [&body](const std::string& name) { return renamed(body, {{name, ""}}) != body; };
    // Not every model asks for each of them.
    if (one.state != Function::State::none && !isUsed("s")) out += "  (void)s;\n";
    for (const std::string& name : one.arguments) {
      if (!isUsed(name)) out += "  (void)" + name + ";\n";
    }
    out += body;
    if (many) {
      for (const std::string& name : one.outputs) out += "  *" + name + "_out = " + name + ";\n";
    } else if (!one.outputs.empty()) {
      out += "  return " + one.outputs[0] + ";\n";
    }
    return out + "}\n";
  }

  std::string startText() const {
    const std::string place = program().state[0].name, speed = program().state[1].name;
    std::string out = lines({"The state at the begin."}, 0) + "static inline " + stateType() + " " + called("start") +
                      "(double " + place + ", double " + speed + ") {\n  " + stateType() + " s;\n";
    bool arrays = false;
    for (const Field& field : program().state) arrays = arrays || field.size > 0;
    if (arrays) out += "  int k;\n";
    for (const Field& field : program().state) {
      const std::string value = withPoint(exactText(field.initial));
      if (field.size > 0)
        out += "  for (k = 0; k < " + std::to_string(field.size) + "; ++k) s." + field.name + "[k] = " + value + ";\n";
      else
        out += "  s." + field.name + " = " + (field.name == place || field.name == speed ? field.name : value) + ";\n";
    }
    return out + "  return s;\n}\n";
  }

  std::string numberText(const std::string& digits) const override { return withPoint(digits); }
  std::string constantName(const std::string& name) const override { return called(name); }
  std::string stateName(const std::string& field) const override { return "s->" + field; }
  std::string elementText(const std::string& array, const std::string& index) const override {
    return array + "[(int)(" + index + ")]";
  }
  std::string conditionalText(const std::string& condition, const std::string& then,
                              const std::string& otherwise) const override {
    return "(" + condition + " ? " + then + " : " + otherwise + ")";
  }
  std::string builtinText(const std::string& name, const std::vector<std::string>& arguments) const override {
    static const std::map<std::string, std::string> names{{"abs", "fabs"}, {"min", "fmin"}, {"max", "fmax"}};
    const auto it = names.find(name);
    return (it == names.end() ? name : it->second) + "(" + joined(arguments) + ")";
  }
  std::string ownCallText(const Function& function, const Expression& call) const override {
    const std::string rest = argumentsOf(call);
    const bool state = function.state != Function::State::none;
    return called(function.name) + "(" + (state ? rest.empty() ? "s" : "s, " : "") + rest + ")";
  }
  std::string assignManyText(const std::vector<std::string>& targets, const Expression& call) const override {
    std::string text = ownCallText(*ownFunction(call.text), call);
    text.pop_back();
    for (const std::string& target : targets) text += ", &" + target;
    return text + ");";
  }
  std::string commentMark() const override { return "//"; }
  std::string callText(const Function& function, const Expression& call) const override {
    return ownCallText(function, call) + ";";
  }
  std::string ifText(const std::string& condition) const override { return "if (" + condition + ") {"; }
  std::string elseIfText(const std::string& condition) const override { return "} else if (" + condition + ") {"; }
  std::string elseText() const override { return "} else {"; }
  std::string whileText(const std::string& condition) const override { return "while (" + condition + ") {"; }
  std::string endText(Statement::Kind) const override { return "}"; }
};

}  // namespace

std::string cText(const Program& program) {
  return C(program).whole();
}

}  // namespace breakaway
