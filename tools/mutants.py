"""Finds places in C++ where a small change would be a fault, and writes source that holds many of these mutants at once.

It reads tokens, not the language: it relies on the project's format, where a binary operator has a space on both sides and a unary
one has none after it. What does not compile in spite of that is left out by the caller (tools/mutate.py). The source that
it writes has the lines of the original, so that a compiler's message names the line of a mutant.
"""
import random
import re
from dataclasses import dataclass, field

TOKEN = re.compile(r"""
      (?P<comment>//[^\n]*|/\*.*?\*/)
    | (?P<directive>^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
    | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
    | (?P<number>\.?\d(?:[eEpP][+-]|'[\da-fA-F]|[\w.])*)
    | (?P<word>[A-Za-z_]\w*)
    | (?P<operator><=>|->\*|<<=|>>=|\.\.\.|::|->|\+\+|--|&&|\|\||[-+*/%&|^=!<>]=|<<|>>|[-+*/%&|^~!=<>?:;,.(){}\[\]])
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

BINARY = {"+": ("Plus", ["Minus"]), "-": ("Minus", ["Plus"]), "*": ("Times", ["Divide"]), "/": ("Divide", ["Times"]),
          "%": ("Modulo", ["Times"]), "&": ("BitAnd", ["BitOr"]), "|": ("BitOr", ["BitAnd"]),
          "<": ("Less", ["LessEqual", "GreaterEqual"]), "<=": ("LessEqual", ["Less", "Greater"]),
          ">": ("Greater", ["GreaterEqual", "LessEqual"]), ">=": ("GreaterEqual", ["Greater", "Less"]),
          "==": ("Equal", ["NotEqual"]), "!=": ("NotEqual", ["Equal"])}
SYMBOLS = {name: symbol for symbol, (name, _) in BINARY.items()}
ASSIGNMENTS = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "|=": "&=", "&=": "|="}
OPPOSITES = {"min": "max", "max": "min"}
OPEN, CLOSE = "([{", ")]}"
#: Before a statement that begins here.
BEFORE_STATEMENT = {";", "{", "}", ")", "else"}
NO_STATEMENT = {"return", "if", "for", "while", "do", "switch", "case", "default", "using", "namespace", "static_assert", "assert", "throw",
                "template", "class", "struct", "public", "private", "protected", "const", "constexpr", "static", "auto", "delete", "new",
                "sizeof", "decltype", "noexcept", "requires", "operator", "friend", "typedef", "enum", "goto", "extern", "inline"}


@dataclass
class Token:
    kind: str
    text: str
    start: int
    line: int

    @property
    def end(self):
        return self.start + len(self.text)


@dataclass
class Mutant:
    file: str
    line: int
    kind: str       # relation, arithmetic, logic, condition, negation, constant, tuned constant, returned value, statement, extremum
    text: str       # "original -> mutated", for a person
    source: str     # the line of the original
    edits: list = field(repr=False)  # (start, end, text, extent): text has {n} where the number goes; extent orders what begins together
    number: int = 0

    def key(self):
        """Names the mutant even after lines were added above it."""
        return f"{self.file}|{self.kind}|{self.text}|{self.source}"


def tokens_of(source):
    """Comments and preprocessor lines are left out."""
    found, line, seen = [], 1, 0
    for match in TOKEN.finditer(source):
        line += source.count("\n", seen, match.start())
        seen = match.start()
        if match.lastgroup not in ("comment", "directive"):
            kind = "string" if match.lastgroup == "mark" else match.lastgroup
            found.append(Token(kind, match.group(), match.start(), line))
    return found


class Finder:
    """The mutants of one file."""

    def __init__(self, file, source, choice=None):
        self.file, self.source = file, source
        self.choice = choice or random.Random(1)
        self.lines = source.split("\n")
        self.tokens = tokens_of(source)
        self.partner = self._partners()
        self.is_skipped = self._skipped()
        self.mutants = []

    def find(self):
        for i, token in enumerate(self.tokens):
            if self.is_skipped[i]:
                if token.text == "constexpr":
                    self._tuned_constant(i)
                continue
            if token.text in BINARY and self._is_spaced(i):
                self._binary(i)
            elif token.text in ("&&", "||") and self._is_spaced(i):
                self._logic(i)
            elif token.text in ("-", "!"):
                self._unary(i)
            elif token.text in ("if", "while"):
                self._condition(i)
            elif token.text in OPPOSITES and self._text(i + 1) == "(":
                self._extremum(i)
            elif token.text == "return":
                self._returned(i)
            elif token.kind == "number":
                self._constant(i)
            if i > 0 and self._text(i - 1) in BEFORE_STATEMENT:
                self._statement(i)
        return self.mutants

    def _text(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def _partners(self):
        partner, stack = {}, []
        for i, token in enumerate(self.tokens):
            if token.text in OPEN and token.kind == "operator":
                stack.append(i)
            elif token.text in CLOSE and token.kind == "operator" and stack:
                partner[i] = stack.pop()
                partner[partner[i]] = i
        return partner

    def _skipped(self):
        """What is checked or fixed when it is compiled, assertions, macros, and heads of templates."""
        skipped = [False] * len(self.tokens)
        for i, token in enumerate(self.tokens):
            end = None
            if token.kind == "word" and self._text(i + 1) == "(" and \
                    (token.text in ("assert", "static_assert", "noexcept", "sizeof", "alignas", "decltype") or token.text.isupper()):
                end = self.partner.get(i + 1)
            elif token.text == "if" and self._text(i + 1) == "constexpr":
                end = self.partner.get(i + 2)
            elif token.text in ("constexpr", "constinit", "using", "case", "enum", "concept"):
                end = self._declaration_end(i)
            elif token.text == "template" and self._text(i + 1) == "<":
                end = next((j for j in range(i, min(i + 80, len(self.tokens))) if self._text(j) == ">"), None)
            if end is not None:
                skipped[i:end + 1] = [True] * (end + 1 - i)
        return skipped

    def _declaration_end(self, i):
        """Of a constant: its `;`. Of a constexpr function or constructor, which runs as well: its head."""
        for j in range(i, min(i + 200, len(self.tokens))):
            if self._text(j) in (";", ":"):
                return j
            if self._text(j) == "{" and self._text(j - 1) in (")", "const", "noexcept", "override"):
                return j
            if self._text(j) in OPEN:
                inner = self.partner.get(j, j)
                if self._text(j) == "{":
                    return inner
        return i

    def _is_spaced(self, i):
        token = self.tokens[i]
        return self.source[token.start - 1].isspace() and self.source[token.end:token.end + 1].isspace()

    def _add(self, i, kind, text, *edits):
        token = self.tokens[i]
        self.mutants.append(Mutant(self.file, token.line, kind, text, self.lines[token.line - 1].strip(), list(edits)))

    def _around(self, first, last, before, after):
        """Edits that put text around the tokens first to last."""
        start, end = self.tokens[first].start, self.tokens[last].end
        return (start, start, before, end - start), (end, end, after, end - start)

    def _binary(self, i):
        token = self.tokens[i]
        if self._text(i - 1) == "operator":
            return
        name, others = BINARY[token.text]
        other = self.choice.choice(others)
        text = f"{token.text} ::carom_mutant::Tag<{{n}}, ::carom_mutant::{name}, ::carom_mutant::{other}>{{{{}}}} {token.text}"
        kind = "relation" if token.text[0] in "<>=!" else "arithmetic"
        self._add(i, kind, f"{token.text} -> {SYMBOLS[other]}", (token.start, token.end, text, 0))

    def _operand_start(self, i):
        """The first token of what a && or || has on its left: for || all of it, for && what no || ends."""
        ends = {";", ",", "?", ":", "=", "return", "&&=", "<<", "co_return"} | ({"||"} if self._text(i) == "&&" else set())
        j = i - 1
        while j >= 0:
            text = self._text(j)
            if text in CLOSE and j in self.partner:
                if text == "}" and self._text(j + 1) not in (".", ")", ",") and self._text(j - 1) != "{":
                    break
                j = self.partner[j] - 1
                continue
            if text in OPEN or text in ends or text in ASSIGNMENTS:
                break
            j -= 1
        return j + 1

    def _operand_end(self, i):
        ends = {";", ",", "?", ":", "&&", "||"} if self._text(i) == "&&" else {";", ",", "?", ":", "||"}
        j = i + 1
        while j < len(self.tokens):
            text = self._text(j)
            if text in OPEN and j in self.partner:
                j = self.partner[j] + 1
                continue
            if text in CLOSE or text in ends:
                break
            j += 1
        return j - 1

    def _logic(self, i):
        first, last = self._operand_start(i), self._operand_end(i)
        if not first < i < last + 1 or self._text(first) in NO_STATEMENT:
            return
        is_and = self._text(i) == "&&"
        token = self.tokens[i]
        start, end = self._around(first, last, "((::carom_mutant::active<{n}>() %s static_cast<bool>(" % ("!=" if is_and else "=="),
                                  ") : %s::carom_mutant::active<{n}>())" % ("" if is_and else "!"))
        middle = (token.start, token.end, ")) ? static_cast<bool>(", 0)
        self._add(i, "logic", "&& -> ||" if is_and else "|| -> &&", start, middle, end)

    def _unary(self, i):
        token = self.tokens[i]
        if self.source[token.end:token.end + 1].isspace() or self._text(i + 1) in ("", ")", "="):
            return
        before = self.tokens[i - 1] if i > 0 else token
        if before.kind in ("number", "string") or before.text in (")", "]") or \
                (before.kind == "word" and before.text not in ("return", "else", "case")):
            return
        if token.text == "-" and self.tokens[i + 1].kind == "number" and before.text == "=":
            return  # a constant, which is mutated as such
        name = "Negate" if token.text == "-" else "Not"
        self._add(i, "negation", f"{token.text}x -> x", (token.start, token.end, f"::carom_mutant::{name}<{{n}}>{{{{}}}} ->* ", 0))

    def _condition(self, i):
        if self._text(i + 1) != "(" or i + 1 not in self.partner:
            return
        first, last = i + 2, self.partner[i + 1] - 1
        depth = 0
        for j in range(first, last + 1):
            depth += (self._text(j) in OPEN) - (self._text(j) in CLOSE)
            if depth == 0 and self._text(j) in (";", "="):
                return  # it declares something
        if first > last:
            return
        edits = self._around(first, last, "::carom_mutant::active<{n}>() != static_cast<bool>(", ")")
        self._add(i, "condition", f"{self._text(i)} (x) -> {self._text(i)} (!x)", *edits)

    def _extremum(self, i):
        if self._text(i - 1) in (".", "->") or i + 1 not in self.partner:
            return
        first, name, other = i, self._text(i), OPPOSITES[self._text(i)]
        if self._text(i - 1) == "::":
            if self._text(i - 2) != "std":
                return
            first, name, other = i - 2, "std::" + name, "std::" + other
        elif self.tokens[i - 1].kind == "word" and self._text(i - 1) != "return":
            return  # its declaration
        if self.partner[i + 1] == i + 2:
            return  # no arguments: a member
        start, end = self.tokens[first].start, self.tokens[i + 1].end
        self._add(i, "extremum", f"{name} -> {other}", (start, end, f"CAROM_MUTANT_CALL({{n}}, {name}, {other}, ", 0))

    def _returned(self, i):
        last = i + 1
        while last < len(self.tokens) and self._text(last) != ";":
            last = self.partner[last] + 1 if self._text(last) in OPEN and last in self.partner else last + 1
        last -= 1
        if last <= i or self._text(i + 1) == "{":
            return
        self._add(i, "returned value", "return x -> return another", *self._around(i + 1, last, "::carom_mutant::returned<{n}>(", ")"))

    def _changed(self, text):
        """Another value for a literal; None for what is no plain number."""
        number = text.rstrip("fFuUlLzZ").replace("'", "")
        if text[:2].lower() in ("0x", "0b"):
            return None
        try:
            value = float(number)
        except ValueError:
            return None
        if value == 0:
            return f"({text} + 1)"
        if "." in number or "e" in number.lower():
            return f"({text} * {self.choice.choice(['2', '0.5f' if text[-1] in 'fF' else '0.5'])})"
        return f"({text} {self.choice.choice(['+', '-'])} 1)"

    def _constant(self, i):
        token, before, after = self.tokens[i], self._text(i - 1), self._text(i + 1)
        changed = self._changed(token.text)
        if changed is None or before == "<" and self.source[token.start - 1] == "<" or after == ">" and not self._is_spaced(i + 1):
            return
        if before == "=" and after == ";" and self._text(i - 2) == ")":
            return  # a pure function
        self._add(i, "constant", f"{token.text} -> {changed[1:-1]}",
                  (token.start, token.end, f"::carom_mutant::constant<{{n}}>({token.text}, {changed})", 0))

    def _tuned_constant(self, i):
        """`constexpr float slop = 0.005f;` outside of a class."""
        if self._text(i - 1) == "static":
            return
        j = i + 1
        while self.tokens[j].kind == "word" or self._text(j) == "::":
            j += 1
        if self._text(j) != "=" or self._text(j + 2) != ";" or self.tokens[j + 1].kind != "number":
            return
        literal, changed = self.tokens[j + 1], self._changed(self._text(j + 1))
        if changed is None:
            return
        kind = f"std::decay_t<decltype({literal.text})>"
        self._add(i, "tuned constant", f"{literal.text} -> {changed[1:-1]}", (self.tokens[i].start, self.tokens[i].end, "const", 0),
                  (literal.start, literal.end, f"::carom_mutant::tuned<{{n}}, {kind}>({literal.text}, {kind}{changed})", 0))

    def _statement(self, i):
        """A call, an assignment or an increment that stands alone; `continue` and `break`."""
        if self._text(i) in ("continue", "break"):
            return self._removed(i, i + 1)
        j = i + 1 if self._text(i) in ("++", "--") else i
        if self.tokens[j].kind != "word" or self._text(j) in NO_STATEMENT or self._text(i - 1) == ")" and not self._follows_condition(i):
            return
        acts = j > i
        while j < len(self.tokens):
            text = self._text(j)
            if text == ";":
                return self._removed(i, j) if acts else None
            if text in ASSIGNMENTS or text == "=":
                end = next((k for k in self._flat(j) if self._text(k) == ";"), None)
                if end is None or self._text(j + 1) in ("delete", "default") or text == "=" and self._text(j - 1) == ")":
                    return
                if text in ASSIGNMENTS:
                    self._assignment(i, j, end)
                return self._removed(i, end)
            if text in ("(", "[") and j in self.partner:
                acts = acts or text == "("
                j = self.partner[j] + 1
                if self.tokens[j].kind == "word":
                    return
                continue
            if text in ("++", "--"):
                acts = True
            elif text not in ("::", ".", "->") and (self.tokens[j].kind != "word" or self.tokens[j + 1].kind == "word"):
                return
            j += 1

    def _flat(self, i):
        """The tokens from i on that are in no bracket of their own."""
        while i < len(self.tokens) and self._text(i) not in CLOSE:
            yield i
            i = self.partner[i] + 1 if self._text(i) in OPEN and i in self.partner else i + 1

    def _follows_condition(self, i):
        head = self.partner.get(i - 1)
        return head is not None and self._text(head - 1) in ("if", "for", "while")

    def _removed(self, i, end):
        begin = self.tokens[i].start
        text = " ".join(self.source[begin:self.tokens[end].end].split())
        self._add(i, "statement", f"{text[:60]} -> (nothing)", (begin, begin, "if (::carom_mutant::active<{n}>()) {{}} else ", 1 << 30))

    def _assignment(self, i, at, end):
        begin, operator = self.tokens[i].start, self.tokens[at]
        other = ASSIGNMENTS[operator.text]
        target = self.source[begin:operator.start]
        value = self.source[operator.end:self.tokens[end].end]
        if "\n" in target + value:
            return
        text = f"if (::carom_mutant::active<{{n}}>()) {escaped(target)}{other}{escaped(value)} else "
        self._add(at, "arithmetic", f"{operator.text} -> {other}", (begin, begin, text, 1 << 29))


def escaped(text):
    return text.replace("{", "{{").replace("}", "}}")


def sample(mutants, count, choice, folder_of):
    """A random choice: to each folder by what it holds, but at least 5; within a folder all kinds in turn."""
    folders = {}
    for mutant in mutants:
        folders.setdefault(folder_of(mutant), {}).setdefault(mutant.kind, []).append(mutant)
    chosen = []
    for folder in sorted(folders):
        kinds = folders[folder]
        share = max(5, round(count * sum(map(len, kinds.values())) / len(mutants)))
        for kind in sorted(kinds):
            choice.shuffle(kinds[kind])
        while share > 0 and any(kinds.values()):
            for kind in sorted(kinds):
                if share > 0 and kinds[kind]:
                    chosen.append(kinds[kind].pop())
                    share -= 1
    return chosen


def written(source, mutants, header, is_header=False):
    """The source with all of these mutants in it. Warnings about them are off: in a header by a pragma, elsewhere by the caller's options."""
    edits = []
    for turn, mutant in enumerate(mutants):
        for start, end, text, extent in mutant.edits:
            # What opens first closes last, also where two surround the same.
            is_closing = start == end and text.startswith(")")
            order = (0, extent, -turn) if is_closing else (1, -extent, turn)
            edits.append((start, order, end, text.format(n=mutant.number)))
    edits.sort(key=lambda edit: edit[:2])
    out, at = [], 0
    for start, _, end, text in edits:
        if start < at:
            raise ValueError(f"two mutants of one place: {text}")
        out += [source[at:start], text]
        at = end
    return f'#include "{header}"\n' + ("#pragma GCC system_header\n" if is_header else "") + "#line 1\n" + "".join(out) + source[at:]
