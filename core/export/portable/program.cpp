#include "export/portable/program.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <functional>
#include <set>

namespace breakaway {

namespace {

using Kind = Expression::Kind;

bool begins(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool goesOn(char c) {
  return begins(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

struct Token {
  enum class Kind { end, number, name, sign, comment };
  Kind kind = Kind::end;
  std::string text;
};

size_t numberEnd(const std::string& text, size_t at) {
  while (at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.' ||
                              text[at] == 'e' || ((text[at] == '-' || text[at] == '+') && text[at - 1] == 'e')))
    ++at;
  return at;
}

std::vector<Token> tokensOf(const std::string& text) {
  std::vector<Token> tokens;
  for (size_t at = 0; at < text.size();) {
    size_t end = at + 1;
    if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
      at = end;
      continue;
    }
    Token::Kind kind = Token::Kind::sign;
    if (text.compare(at, 2, "//") == 0) {
      end = std::min(text.find('\n', at), text.size());
      kind = Token::Kind::comment;
    } else if (begins(text[at])) {
      while (end < text.size() && (goesOn(text[end]) || text[end] == '.')) ++end;
      kind = Token::Kind::name;
    } else if (std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
      end = numberEnd(text, at);
      kind = Token::Kind::number;
    } else {
      for (const char* two : {"<=", ">=", "==", "!=", "&&", "||", "->"}) {
        if (text.compare(at, 2, two) == 0) end = at + 2;
      }
    }
    tokens.push_back({kind, text.substr(at, end - at)});
    at = end;
  }
  tokens.push_back({});
  return tokens;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : tokens_(tokensOf(text)) {}

  std::vector<Function> functions() {
    std::vector<Function> all;
    while (now().kind != Token::Kind::end) all.push_back(function());
    return all;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  bool is(const std::string& text) const { return now().text == text; }
  bool took(const std::string& text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  std::string taken() { return tokens_[at_++].text; }
  void take([[maybe_unused]] const std::string& text) {
    assert(is(text));
    ++at_;
  }

  static std::string commentIn(const std::string& token) {
    const size_t first = token.find_first_not_of("/ ");
    return first == std::string::npos ? "" : token.substr(first);
  }

  Function function() {
    Function one;
    while (now().kind == Token::Kind::comment) one.comment.push_back(commentIn(taken()));
    one.shown = took("shown");
    take("function");
    one.name = taken();
    take("(");
    while (!took(")")) {
      const bool changed = took("&");
      const std::string name = taken();
      if (name == "s")
        one.state = changed ? Function::State::changed : Function::State::read;
      else
        one.arguments.push_back(name);
      took(",");
    }
    if (took("->")) {
      do one.outputs.push_back(taken());
      while (took(","));
    }
    one.body = block();
    return one;
  }

  Statements block() {
    Statements all;
    take("{");
    while (!took("}")) all.push_back(statement());
    return all;
  }

  Statement statement() {
    if (now().kind == Token::Kind::comment) return {.kind = Statement::Kind::comment, .text = commentIn(taken())};
    if (took("return")) {
      take(";");
      return {.kind = Statement::Kind::stop};
    }
    if (is("if") || is("while")) return asked();
    Statement one{.kind = Statement::Kind::assign};
    if (took("(")) {
      do one.targets.push_back(primary());
      while (took(","));
      take(")");
    } else {
      one.targets.push_back(primary());
    }
    if (one.targets.size() == 1 && one.targets[0].kind == Kind::call) {
      one.kind = Statement::Kind::call;
      one.value = one.targets[0];
      one.targets.clear();
    } else {
      take("=");
      one.value = expression();
    }
    take(";");
    return one;
  }

  Statement asked() {
    Statement one{.kind = taken() == "if" ? Statement::Kind::branch : Statement::Kind::loop};
    take("(");
    one.value = expression();
    take(")");
    one.body = block();
    if (one.kind == Statement::Kind::branch && took("else")) {
      if (is("if"))
        one.otherwise.push_back(asked());
      else
        one.otherwise = block();
    }
    return one;
  }

  Expression expression() {
    Expression condition = binary(0);
    if (!took("?")) return condition;
    Expression then = expression();
    take(":");
    Expression otherwise = expression();
    return {Kind::conditional, "?", {std::move(condition), std::move(then), std::move(otherwise)}};
  }

  Expression binary(size_t level) {
    static const std::vector<std::vector<std::string>> levels{
        {"||"}, {"&&"}, {"<", "<=", ">", ">=", "==", "!="}, {"+", "-"}, {"*", "/"}};
    if (level == levels.size()) return unary();
    Expression left = binary(level + 1);
    const auto& here = levels[level];
    while (now().kind == Token::Kind::sign && std::find(here.begin(), here.end(), now().text) != here.end()) {
      const std::string sign = taken();
      Expression right = binary(level + 1);
      left = {Kind::binary, sign, {std::move(left), std::move(right)}};
    }
    return left;
  }

  Expression unary() {
    for (const char* sign : {"-", "!"}) {
      if (took(sign)) return {Kind::unary, sign, {unary()}};
    }
    return primary();
  }

  Expression primary() {
    if (took("(")) {
      Expression inner = expression();
      take(")");
      return inner;
    }
    if (took("&")) return {Kind::name, taken()};
    if (now().kind == Token::Kind::number) return {Kind::number, taken()};
    assert(now().kind == Token::Kind::name);
    Expression one{Kind::name, taken()};
    if (took("[")) {
      one.kind = Kind::element;
      one.parts.push_back(expression());
      take("]");
    } else if (took("(")) {
      one.kind = Kind::call;
      while (!took(")")) {
        one.parts.push_back(expression());
        took(",");
      }
    }
    return one;
  }

  std::vector<Token> tokens_;
  size_t at_ = 0;
};

void eachCall(const Expression& expression, const std::function<void(const std::string&)>& act) {
  if (expression.kind == Kind::call) act(expression.text);
  for (const Expression& part : expression.parts) eachCall(part, act);
}

void eachCall(const Statements& block, const std::function<void(const std::string&)>& act) {
  for (const Statement& one : block) {
    eachCall(one.value, act);
    for (const Expression& target : one.targets) eachCall(target, act);
    eachCall(one.body, act);
    eachCall(one.otherwise, act);
  }
}

void addLocals(const Statements& block, const Function& function, std::vector<std::string>& names) {
  for (const Statement& one : block) {
    for (const Expression& target : one.targets) {
      const std::string& name = target.text;
      const auto isIn = [&name](const std::vector<std::string>& all) {
        return std::find(all.begin(), all.end(), name) != all.end();
      };
      if (target.kind == Kind::name && name.find('.') == std::string::npos && !isIn(names) && !isIn(function.outputs))
        names.push_back(name);
    }
    addLocals(one.body, function, names);
    addLocals(one.otherwise, function, names);
  }
}

}  // namespace

std::vector<std::string> Function::locals() const {
  std::vector<std::string> names;
  addLocals(body, *this, names);
  return names;
}

std::vector<Function> functionsIn(const std::string& text) {
  return Reader(text).functions();
}

std::string renamed(const std::string& text, const std::vector<std::pair<std::string, std::string>>& names) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const bool field = text[at] == '.' && at + 1 < text.size() && begins(text[at + 1]);
    if ((!begins(text[at]) && !field) || (at > 0 && goesOn(text[at - 1]) && !field)) {
      out += text[at++];
      continue;
    }
    size_t end = at + 1;
    while (end < text.size() && goesOn(text[end])) ++end;
    const std::string name = text.substr(at, end - at);
    const auto it = std::find_if(names.begin(), names.end(), [&name](const auto& one) { return one.first == name; });
    out += it == names.end() ? name : it->second;
    at = end;
  }
  return out;
}

std::vector<Function> needed(const std::vector<Function>& functions) {
  std::vector<Function> order;
  std::set<std::string> done;
  const std::function<void(const std::string&)> add = [&](const std::string& name) {
    const auto it =
        std::find_if(functions.begin(), functions.end(), [&name](const Function& one) { return one.name == name; });
    if (it == functions.end() || !done.insert(name).second) return;
    eachCall(it->body, add);
    order.push_back(*it);
  };
  for (const Function& one : functions) {
    if (one.shown) add(one.name);
  }
  return order;
}

bool isIdentifier(const std::string& text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(), goesOn);
}

}  // namespace breakaway
