"""Runs what was exported as Modelica or MATLAB: reads the few constructs that such a file uses, and no others.

read_as_python.py modelica|matlab FILE INPUTS: INPUTS has a row of numbers for each step, the last of them its length;
prints the encoder's reading and the velocity before each step."""

import copy
import math
import re
import sys


class Array(list):
    """Counts from 1."""

    def __getitem__(self, index):
        assert index >= 1
        return list.__getitem__(self, int(index) - 1)

    def __setitem__(self, index, value):
        assert index >= 1
        list.__setitem__(self, int(index) - 1, value)


class State:
    pass


def closing(text, start):
    depth = 0
    for k in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[k], 0)
        if depth == 0:
            return k
    raise SyntaxError(text)


def split_at(text, word):
    depth = 0
    for k, c in enumerate(text):
        depth += {"(": 1, ")": -1}.get(c, 0)
        if depth == 0 and text.startswith(word, k):
            return text[:k], text[k + len(word):]
    raise SyntaxError(text)


def conditionals(text):
    """(if c then a else b) in Python's order."""
    while "(if " in text:
        start = text.rindex("(if ")
        end = closing(text, start)
        condition, rest = split_at(text[start + 4:end], " then ")
        yes, no = split_at(rest, " else ")
        text = text[:start] + "((" + yes + ") if_ (" + condition + ") else_ (" + no + "))" + text[end + 1:]
    return text.replace(" if_ ", " if ").replace(" else_ ", " else ")


class Writer:
    def __init__(self):
        self.lines, self.depth = [], 0

    def line(self, text):
        self.lines.append("  " * self.depth + text)

    def begin(self, text):
        self.line(text)
        self.depth += 1
        self.line("pass")

    def end(self):
        self.depth -= 1


def modelica(text):
    out, function, outputs, name = Writer(), False, [], None
    lines = [re.sub(r'\s*"[^"]*"', "", line.split("//")[0]).strip() for line in text.splitlines()]
    lines = [line for line in lines if line]
    k = 0
    while k < len(lines):
        line = lines[k]
        k += 1
        if name is None:
            name = re.fullmatch(r"package (\w+)", line).group(1)
        elif m := re.fullmatch(r"constant Real (\w+) = (\S+);", line):
            out.line(f"{m.group(1)} = {m.group(2)}")
        elif m := re.fullmatch(r"(record|block) (\w+)", line):
            while lines[k] != f"end {m.group(2)};":
                k += 1
            k += 1
        elif m := re.fullmatch(r"function (\w+)", line):
            function, inputs, outputs = m.group(1), [], []
            while lines[k] != "algorithm":
                if m := re.fullmatch(r"input (?:State|Real) (\w+)(?: = \S+)?;", lines[k]):
                    inputs.append(m.group(1))
                elif m := re.fullmatch(r"output (?:State|Real) (\w+);", lines[k]):
                    outputs.append(m.group(1))
                elif lines[k] != "protected" and not re.fullmatch(r"Real \w+;", lines[k]):
                    raise SyntaxError(lines[k])
                k += 1
            k += 1
            out.begin(f"def {function}({', '.join(inputs)}):")
            if outputs == ["s"]:
                out.line("s = State()")
        elif function and line == f"end {function};":
            out.line("return " + ", ".join(outputs))
            out.end()
            function = False
        elif line == f"end {name};":
            break
        elif line == "return;":
            out.line("return " + ", ".join(outputs))
        elif line in ("end if;", "end while;"):
            out.end()
        elif m := re.fullmatch(r"(if|elseif|while) (.*) (?:then|loop)", line):
            if m.group(1) == "elseif":
                out.end()
            out.begin({"elseif": "elif"}.get(m.group(1), m.group(1)) + " " + expression(m.group(2)) + ":")
        elif line == "else":
            out.end()
            out.begin("else:")
        elif m := re.fullmatch(r"(.*?) := (.*);", line):
            value = expression(m.group(2))
            out.line(expression(m.group(1)) + " = " + ("copy.deepcopy(before)" if value == "before" else value))
        else:
            raise SyntaxError(line)
    return "\n".join(out.lines)


def expression(text):
    return conditionals(text).replace("^", "**").replace("<>", "!=")


def matlab(text):
    out, function, outputs, open_blocks = Writer(), False, [], []
    arrays = set(re.findall(r"s\.(\w+) = repmat", text))
    name = re.search(r"classdef (\w+)", text).group(1)

    def read(part):
        part = part.replace(name + ".", "").replace("~=", "!=").replace("&&", " and ").replace("||", " or ")
        for array in arrays:
            while m := re.search(rf"s\.{array}\(", part):
                end = closing(part, m.end() - 1)
                part = part[:m.end() - 1] + "[" + part[m.end():end] + "]" + part[end + 1:]
        return part

    for line in text.splitlines():
        line = line.split("%")[0].strip()
        if not line:
            continue
        if m := re.fullmatch(r"(classdef \w+|properties \(Constant\)|methods \(Static\))", line):
            open_blocks.append("frame")
        elif m := re.fullmatch(r"function (\[?[\w, ]+\]?) = (\w+)\((.*)\)", line):
            outputs = m.group(1).strip("[]").split(", ")
            function = True
            open_blocks.append("function")
            out.begin(f"def {m.group(2)}({m.group(3)}):")
            if outputs == ["s"]:
                out.line("s = copy.deepcopy(s)" if m.group(3).startswith("s") else "s = State()")
        elif line == "end":
            block = open_blocks.pop()
            if block == "function":
                out.line("return " + ", ".join(outputs))
                function = False
            if block != "frame":
                out.end()
        elif line == "return;":
            out.line("return " + ", ".join(outputs))
        elif m := re.fullmatch(r"(if|elseif|while) (.*)", line):
            if m.group(1) == "elseif":
                out.end()
            else:
                open_blocks.append(m.group(1))
            out.begin({"elseif": "elif"}.get(m.group(1), m.group(1)) + " " + read(m.group(2)) + ":")
        elif line == "else":
            out.end()
            out.begin("else:")
        elif m := re.fullmatch(r"(.*?) = (.*);", line):
            out.line(read(m.group(1)).strip("[]") if m.group(1).startswith("[") else read(m.group(1)))
            out.lines[-1] += " = " + read(m.group(2))
        else:
            raise SyntaxError(line)
    assert not open_blocks
    return "\n".join(out.lines)


def main():
    language, file, inputs = sys.argv[1:]
    with open(file, encoding="utf-8") as source:
        text = source.read()
    known = {one: getattr(math, one) for one in ("sin", "cos", "exp", "log", "sqrt", "tanh", "ceil")}
    known.update(State=State, copy=copy, integer=int, power=lambda a, b: a**b, fill=lambda v, n: Array([v] * n),
                 repmat=lambda v, _, n: Array([v] * n))
    exec(modelica(text) if language == "modelica" else matlab(text), known)
    state = known["start"](0.0, 0.0)
    place = "angle_rad" if hasattr(state, "angle_rad") else "position_m"
    speed = "velocity_rad_per_s" if hasattr(state, "velocity_rad_per_s") else "velocity_m_per_s"
    for _ in range(2):
        setattr(state, place, getattr(state, place) - known["reading"](state))
    with open(inputs, encoding="utf-8") as rows:
        for row in rows:
            print(repr(known["reading"](state)), repr(getattr(state, speed)))
            state = known["step"](state, *[float(one) for one in row.split()])


main()
