"""What commands say about their options, by --print-contract, and values to try them with."""
import subprocess

COMMON = {"output", "threads", "quiet", "notes", "help", "version"}


class Option:
    def __init__(self, name, unit):
        self.name, self.unit = name, unit  # unit "" is a flag
        self.default, self.needs, self.range, self.limit = "", "", None, False

    def is_number(self):
        return self.range is not None


class Command:
    def __init__(self, name):
        self.name, self.options, self.into, self.out = name, {}, "", ""
        text = subprocess.run([name, "--print-contract"], capture_output=True, text=True, check=True).stdout
        for line in text.splitlines():
            key, _, rest = line.partition(" ")
            word, _, more = rest.partition(" ")
            if key == "in":
                self.into = rest
            elif key == "out":
                self.out = rest
            elif key in ("flag", "option"):
                if word not in COMMON:
                    self.options[word] = Option(word, more if key == "option" else "")
            elif word in self.options:
                option = self.options[word]
                if key == "default":
                    option.default = more
                elif key == "needs":
                    option.needs = more
                elif key == "limit":
                    option.limit = True
                elif key == "range":
                    least, most, *flags = more.split()
                    option.range = (float(least), float(most), "open" in flags, "zero" in flags)


def commands():
    names = [line.split()[0] for line in
             subprocess.run(["filum", "list"], capture_output=True, text=True, check=True).stdout.splitlines()]
    return [Command(name) for name in names]


def shown(value):
    return f"{value:.10f}".rstrip("0").rstrip(".")


def numbers_of(option):
    """How many numbers the option takes, by its unit: "X,Y,Z"; and by its default."""
    if option.unit.endswith(",..."):
        return 1
    return max(option.unit.count(",") + 1, option.default.count(",") + 1)


def values(option):
    """Values to try that are not the default."""
    if option.unit == "":
        return ["=false"] if option.default == "true" else [""]
    if option.is_number():
        least, most, is_open, zero = option.range
        old = float((option.default or "0").split(",")[0])
        middle = least + 0.4 * (most - least)
        tries = [old * 2, old / 2, old + 1, old * 1.25, least + 1, 30, middle if middle < 1000 else old]
        whole = option.unit in ("N", "REGIONS", "POINTS")
        tries = [round(v) if whole else v for v in tries]
        fit = [v for v in tries if least <= v <= most and not (is_open and v == least)]
        count = numbers_of(option)
        texts = [",".join([shown(v)] * count) for v in fit]
        return [t for t in dict.fromkeys(texts) if t != option.default]
    if "|" in option.unit and option.default in option.unit.split("|"):
        return [v for v in option.unit.split("|") if v != option.default]
    return []


def settings_for(command, option, depth=0):
    """Options that what `option` needs is so, as words; one choice of possibly several."""
    words = []
    for term in option.needs.split():
        if term.startswith("!") or depth > 3:
            continue  # true by default
        choice = term.split("/")[0]
        name, _, choices = choice.partition("=")
        other = command.options[name]
        if choices and other.default in choices.split("|"):
            continue
        tried = choices.split("|") if choices else values(other)
        if not tried:
            return None  # a file or a text: only a witness knows
        first = settings_for(command, other, depth + 1)
        if first is None:
            return None
        words += first + [word(other, tried[0])]
    return words


def word(option, value):
    if option.unit == "" and value in ("", "true"):
        return "--" + option.name
    return f"--{option.name}={value.removeprefix('=')}"
