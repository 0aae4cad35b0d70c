"""What a C++17 source defines, read from its text: functions with their lengths, and classes with
their members.

This is no compiler: macros are not expanded, and all branches of an #if are read. It knows what our
sources have once clang-format has been over them: free functions, member functions in and outside
their classes, constructors with initializer lists, operators, lambdas, nested and local classes,
enumerations, initializers in braces, raw strings.
"""

import dataclasses
import re

TOKEN = re.compile(r"""
    (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<literal>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"
      | (?:u8|[uUL])?"(?:\\.|[^"\\\n])*"
      | (?:u8|[uUL])?'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:[eEpP][+-]|'?[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign>::|->|\.\.\.|[-+*/%^&|!=]=|<=|>=|&&|\|\||[^\s\w])
""", re.VERBOSE | re.MULTILINE | re.DOTALL)
CLOSING = {"(": ")", "[": "]", "{": "}"}
WORD = re.compile(r"[A-Za-z_]\w*$")
DEFINED = "class {}"  # stands for a class or enumeration whose braces have been read
# What stands before parentheses that are no parameters.
NOT_NAMES = {"alignas", "decltype", "noexcept", "__attribute__", "explicit"}


@dataclasses.dataclass
class Function:
    name: str   # with its class where it is defined outside of it
    line: int   # of its opening brace
    lines: int  # from the opening brace's line to the closing brace's, both counted


@dataclasses.dataclass
class Class:
    name: str
    line: int
    functions: list  # names of declared member functions; a deleted one is none, nor is a friend
    data: list       # names of data members; a static one is none


@dataclasses.dataclass
class Outline:
    functions: list
    classes: list


def tokens_of(text):
    """(token, line) pairs without comments and directives; a literal is '""'."""
    tokens, line, at = [], 1, 0
    for match in TOKEN.finditer(text):
        line += text.count("\n", at, match.start())
        at = match.start()
        kind = match.lastgroup if match.lastgroup != "mark" else "literal"
        if kind not in ("directive", "comment"):
            tokens.append(('""' if kind == "literal" else match.group(), line))
    return tokens


def is_word(token):
    return bool(WORD.match(token))


def without_templates(head):
    """A declaration without `template <...>` and attributes before it."""
    while head and (head[0] == "template" or head[0][0] in "<["):
        head = head[1:]
    return head


def parameters_at(head):
    """Where a declaration's parameter list stands among its tokens; None: it has none."""
    for i, token in enumerate(head):
        if token == "=" and i > 0 and head[i - 1] != "operator":
            return None
        if token[0] != "(" or i == 0 or head[i - 1] in NOT_NAMES:
            continue
        if head[i - 1] == "operator" and token == "()":
            continue  # the name of the call operator
        return i
    return None


def name_before(head, end):
    """The name, with what qualifies it, that ends before head[end]."""
    begin = end
    for i in range(max(0, end - 3), end):
        if head[i] == "operator":
            begin = i
    if begin == end:
        begin = end - 1
        if begin > 0 and head[begin][0] == "<":
            begin -= 1
    if begin > 0 and head[begin - 1] == "~":
        begin -= 1
    while begin > 1 and head[begin - 1] == "::":
        begin -= 2
        if begin > 0 and head[begin][0] == "<":
            begin -= 1
    spaced = " " if head[end - 2] == "operator" and is_word(head[end - 1]) else ""
    return "".join(head[begin:end - 1]) + spaced + head[end - 1]


def declared_name(head):
    """The name of the variable that a declaration with an initializer declares."""
    ends = [i for i, token in enumerate(head) if token == "=" or token[0] in "([{"]
    return name_before(head, ends[0] if ends else len(head)) if ends != [0] and head else "a macro"


class Reader:
    """Walks over the tokens of a source. Stands at namespace or class scope; what is inside a
    function is passed over."""

    def __init__(self, text):
        pairs = tokens_of(text)
        self.tokens = [token for token, _ in pairs]
        self.lines = [line for _, line in pairs]
        self.outline = Outline([], [])

    def end_of(self, i):
        """The index of what closes the bracket at i."""
        opening, closing, depth = self.tokens[i], CLOSING[self.tokens[i]], 0
        for j in range(i, len(self.tokens)):
            depth += (self.tokens[j] == opening) - (self.tokens[j] == closing)
            if depth == 0:
                return j
        raise ValueError(f"line {self.lines[i]}: {opening} is never closed")

    def end_of_angle(self, i):
        """The index of the > that closes the < at i; None: it is the sign for `less`."""
        j = i + 1
        while j < len(self.tokens):
            token = self.tokens[j]
            if token == ">":
                return j
            if token in (";", "{", "}", ")"):
                return None
            if token in "([":
                j = self.end_of(j)
            elif token == "<":
                j = self.end_of_angle(j) or j
            j += 1
        return None

    def lambda_body(self, i):
        """The index of the brace that opens the body of the lambda that begins at i; None: none
        begins there."""
        before = self.tokens[i - 1] if i > 0 else ";"
        if self.tokens[i] != "[" or before == "[" or before in ")]" or self.tokens[i + 1] == "[":
            return None
        if is_word(before) and before != "return":
            return None
        j = self.end_of(i) + 1
        while self.tokens[j] not in ("{", ";", ",", ")", "}", "="):
            j = self.end_of(j) + 1 if self.tokens[j] == "(" else j + 1
        return j if self.tokens[j] == "{" else None

    def add_function(self, name, i):
        """Notes the function whose body opens at i; returns the index of its closing brace."""
        end = self.end_of(i)
        lines = self.lines[end] - self.lines[i] + 1
        self.outline.functions.append(Function(name, self.lines[i], lines))
        return end

    def pass_over(self, i, name):
        """Notes the lambdas in the brackets that open at i, outside of any function; returns the
        index of what closes them."""
        end = self.end_of(i)
        j = i + 1
        while j < end:
            body = self.lambda_body(j)
            j = j + 1 if body is None else self.add_function(f"lambda of {name}", body) + 1
        return end

    def read(self, i, owner):
        """Reads a scope from i on; owner: its Class, or None for a namespace's. Returns the index
        of the brace that closes it, or the number of tokens."""
        head = []
        while i < len(self.tokens):
            token = self.tokens[i]
            body = self.lambda_body(i) if "=" in head else None
            if token == "}":
                return i
            if token == ";":
                self.add_member(owner, head)
                head = []
            elif token == ":" and head in (["public"], ["private"], ["protected"]):
                head = []
            elif body is not None:
                i = self.add_function(f"lambda of {declared_name(head)}", body)
                head.append("{}")
            elif token in ("(", "["):
                end = self.pass_over(i, declared_name(head))
                head.append("".join(self.tokens[i:end + 1]))
                i = end
            elif token == "<" and head and (is_word(head[-1]) and head[-1] != "operator"):
                end = self.end_of_angle(i)
                head.append(token if end is None else "".join(self.tokens[i:end + 1]))
                i = i if end is None else end
            elif token == "{":
                i, head = self.read_braces(i, head, owner)
            else:
                head.append(token)
            i += 1
        return i

    def read_scope(self, i, owner):
        """Reads the scope that opens at i; returns the index of the brace that closes it."""
        end = self.read(i + 1, owner)
        if end == len(self.tokens):
            raise ValueError(f"line {self.lines[i]}: {{ is never closed")
        return end

    def read_braces(self, i, head, owner):
        """Reads what opens at i behind the head of a declaration. Returns the index of its end, and
        what the head is from there on."""
        plain = without_templates(head)
        parameters = parameters_at(plain)
        if "namespace" in plain[:2] or plain == ["extern", '""']:
            return self.read_scope(i, None), []
        if parameters is None and "enum" in plain and "=" not in plain:
            return self.end_of(i), [DEFINED]
        if parameters is None and {"class", "struct", "union"} & set(plain) and "=" not in plain:
            found = Class(self.class_name(plain), self.lines[i], [], [])
            self.outline.classes.append(found)
            return self.read_scope(i, found), [DEFINED]
        if parameters is None:  # an initializer
            return self.pass_over(i, declared_name(plain)), head + ["{}"]
        if ":" in plain[parameters:] and (is_word(plain[-1]) or plain[-1][0] == "<"):
            return self.pass_over(i, plain[-1]), head + ["{}"]  # of one member in a constructor
        self.add_member(owner, head)
        name = name_before(plain, parameters)
        return self.add_function(name if owner is None else f"{owner.name}::{name}", i), []

    @staticmethod
    def class_name(head):
        """What the class is called whose head this is; '': nothing."""
        kind = next(i for i, token in enumerate(head) if token in ("class", "struct", "union"))
        name = ""
        for token in head[kind + 1:]:
            if token in (":", "final"):
                break
            name = name if token[0] in "([" or token == "alignas" else name + token
        return name

    @staticmethod
    def add_member(owner, head):
        """Notes what a declaration adds to the class that it is in."""
        head = without_templates(head)
        if owner is None or not head or head[0] in ("using", "typedef", "friend", "static_assert"):
            return
        if head == [DEFINED] or head[-2:] == ["=", "delete"]:
            return
        parameters = parameters_at(head)
        if parameters is not None and not head[parameters].startswith(("(*", "(&")):
            owner.functions.append(name_before(head, parameters))
            return
        if parameters is None and head[0] in ("class", "struct", "union", "enum") and len(head) < 3:
            return  # declared ahead
        if "static" in head:
            return
        declarator = []
        for token in head + [","]:
            if token == ",":
                ends = [i for i, part in enumerate(declarator) if part in "=:" or part[0] in "{["]
                words = declarator[:ends[0]] if ends else declarator
                owner.data.append(words[-1].strip("(*&)") if parameters is None
                                  else head[parameters].strip("(*&)"))
                declarator = []
            else:
                declarator.append(token)


def outline(text):
    """The functions and classes of a source. Errors: ValueError where its brackets do not match."""
    reader = Reader(text)
    end = reader.read(0, None)
    if end < len(reader.tokens):
        raise ValueError(f"line {reader.lines[end]}: nothing is open that this brace closes")
    return reader.outline
