#!/usr/bin/env python3
"""Manual pages and shells' completion, made of what the programs say about themselves.

    pages.py CLI WINDOW            writes man/ and completion/ beside this file
    pages.py CLI WINDOW --check    says which of them are stale; exit status 1 if any

CLI and WINDOW are the built programs. They are asked with --help, so an option that is added to a verb is in all pages
after this was run. The pages are kept with the sources, as building them would need the programs to run on the machine
that builds."""
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
EXIT = [("0", "Done."), ("1", "Wrong use."), ("2", "Bad input."), ("3", "Problems were found."), ("4", "Could not write.")]


def ask(program, *words):
    environment = dict(os.environ, LC_ALL="C", LANGUAGE="", XDG_CONFIG_HOME="/nonexistent")
    return subprocess.run([program, *words], capture_output=True, text=True, check=True, env=environment).stdout


def options_of(text):
    """[(names, value, sentence)] of the part "Options:" as QCommandLineParser prints it."""
    found = []
    for line in text.partition("Options:\n")[2].partition("\nArguments:")[0].splitlines():
        head = re.match(r"  (-\S.*?)(?:  +(.*))?$", line)
        if head:
            names, value = head[1], ""
            if "<" in names:
                names, _, value = names.partition(" <")
                value = value.rstrip(">")
            found.append([[n.strip() for n in names.split(",")], value, head[2] or ""])
        elif found and line.strip():
            found[-1][2] = (found[-1][2] + " " + line.strip()).strip()
    return found


class Verb:
    def __init__(self, cli, name):
        text = ask(cli, name, "--help")
        self.name = name
        self.purpose = text.partition("\n")[0]
        self.usage = re.search(r"^Usage: (.*)$", text, re.M)[1]
        self.options = options_of(text)


def roff(text):
    """Text that troff takes as it is: hyphens that can be copied, no line that is a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("…", "...")
    return "\\&" + text if text.startswith((".", "'")) else text


def page_head(name, what):
    return [f'.TH {name.upper()} 1 "@FFF_RELEASE_DATE@" "FlatFitFab @PROJECT_VERSION@" "User Commands"', ".SH NAME",
            f"{roff(name)} \\- {roff(what)}"]


def page_options(options):
    lines = []
    for names, value, sentence in options:
        head = ", ".join(f"\\fB{roff(n)}\\fR" for n in names) + (f" \\fI{roff(value)}\\fR" if value else "")
        lines += [".TP", head, roff(sentence)]
    return lines


def page_usage(usage):
    program, _, rest = usage.partition(" ")
    return [f"\\fB{roff(program)}\\fR {roff(rest)}"]


def cli_page(verbs, ending):
    lines = page_head("flatfitfab-cli", "checks, cuts and draws models of flat parts")
    lines += [".SH SYNOPSIS"]
    for verb in verbs:
        lines += page_usage(verb.usage) + [".br"]
    lines += ["\\fBflatfitfab\\-cli\\fR \\-\\-version | \\-\\-help | VERB \\-\\-help", ".SH DESCRIPTION", roff(ending)]
    for verb in verbs:
        lines += [f".SH {roff(verb.name.upper())}", roff(verb.purpose) + ".", ".PP"] + page_usage(verb.usage)
        lines += page_options(verb.options)
    lines += [".SH EXIT STATUS"]
    for number, meaning in EXIT:
        lines += [".TP", f"\\fB{number}\\fR", meaning]
    return lines + [".SH SEE ALSO", "\\fBflatfitfab\\fR(1)"]


def window_page(text):
    what = re.search(r"^Usage:.*\n(.*)$", text, re.M)[1].rstrip(".")
    lines = page_head("flatfitfab", what[0].lower() + what[1:])
    lines += [".SH SYNOPSIS", "\\fBflatfitfab\\fR [options] [FILE...]", ".SH DESCRIPTION",
              "Opens each FILE in a window: a .fff file or a FlatFab .txt file. Without one, the start page has samples.",
              "Press F1 there for help, Ctrl+K for anything that the program can do.", ".SH OPTIONS"]
    return lines + page_options(options_of(text)) + [".SH SEE ALSO", "\\fBflatfitfab\\-cli\\fR(1)"]


def flags(options):
    return [n for names, _, _ in options for n in names]


def words_of(sentence):
    """The words of "expects a, b or c": of "svg, dxf or fff; …", nothing of a sentence without such a list."""
    list_ = re.match(r"(?:[^:;()]*: )?((?:[\w.-]+, )+[\w.-]+ or [\w.-]+)[;. (]", sentence)
    return re.split(r", | or ", list_[1]) if list_ else []


def bash(name, verbs, options):
    lines = [f"# Completion of {name} in bash; made by packaging/linux/pages.py.", f"_{name.replace('-', '_')}()", "{",
             "    local word=$2 before=$3 flags=",
             "    COMPREPLY=()"]
    if verbs:
        lines += ["    if [ \"$COMP_CWORD\" = 1 ]; then",
                  f"        COMPREPLY=($(compgen -W '{' '.join(v.name for v in verbs)} --help --version' -- \"$word\"))",
                  "        return", "    fi", "    case \"${COMP_WORDS[1]}:$before\" in"]
        for verb in verbs:
            for names, value, sentence in verb.options:
                if value and words_of(sentence):
                    for n in names:
                        lines += [f"    {verb.name}:{n}) COMPREPLY=($(compgen -W '{' '.join(words_of(sentence))}' -- \"$word\")); return ;;"]
        lines += ["    esac", "    case \"${COMP_WORDS[1]}\" in"]
        lines += [f"    {v.name}) flags='{' '.join(flags(v.options))}' ;;" for v in verbs] + ["    esac"]
    else:
        lines += [f"    flags='{' '.join(flags(options))}'"]
    return lines + ["    if [[ $word == -* ]]; then", "        COMPREPLY=($(compgen -W \"$flags\" -- \"$word\"))", "    else",
                    "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")", "    fi", "}",
                    f"complete -o filenames -F _{name.replace('-', '_')} {name}"]


def zsh_text(sentence):
    """Between quotes and within brackets of _arguments."""
    return sentence.replace("'", "'\\''").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def zsh_options(options, indent):
    lines = []
    for names, value, sentence in options:
        group = f"({' '.join(names)})" if len(names) > 1 else ""
        words = words_of(sentence)
        action = f":{zsh_text(value)}:({' '.join(words)})" if words else f":{zsh_text(value)}:_files"
        for n in names:
            lines += [f"{indent}'{group}{n}[{zsh_text(sentence)}]{action if value else ''}' \\"]
    return lines


def zsh(name, verbs, options):
    lines = [f"#compdef {name}", "# Made by packaging/linux/pages.py."]
    if not verbs:
        return lines + ["_arguments \\"] + zsh_options(options, "    ") + ["    '*:file:_files'"]
    lines += ["if (( CURRENT == 2 )); then", "    local -a verbs=("]
    lines += [f"        '{v.name}:{zsh_text(v.purpose)}'" for v in verbs]
    lines += ["    )", "    _describe verb verbs", "    return", "fi", "local verb=$words[2]",
              "shift words", "(( CURRENT-- ))", "case $verb in"]
    for v in verbs:
        lines += [f"{v.name})", "    _arguments \\"] + zsh_options(v.options, "        ") + ["        '*:file:_files' ;;"]
    return lines + ["esac"]


def fish_options(name, options, condition):
    lines = []
    for names, value, sentence in options:
        text = f"complete -c {name}{condition}"
        for n in names:
            text += f" -l {n[2:]}" if n.startswith("--") else f" -s {n[1:]}"
        if value:
            text += " -r"
        if words_of(sentence):
            text += f" -f -a '{' '.join(words_of(sentence))}'"
        quoted = sentence.replace("\\", "\\\\").replace("'", "\\'")
        lines += [f"{text} -d '{quoted}'"]
    return lines


def fish(name, verbs, options):
    lines = [f"# Completion of {name} in fish; made by packaging/linux/pages.py."]
    for v in verbs or []:
        quoted = v.purpose.replace("'", "\\'")
        lines += [f"complete -c {name} -n __fish_use_subcommand -f -a {v.name} -d '{quoted}'"]
        lines += fish_options(name, v.options, f" -n '__fish_seen_subcommand_from {v.name}'")
    return lines + fish_options(name, options or [], "")


def pages(cli, window):
    """{path: text} of all that this file makes."""
    help_ = ask(cli, "--help")
    verbs = [Verb(cli, name) for name in re.findall(r"^  flatfitfab-cli ([a-z]+) ", help_, re.M)]
    of_window = ask(window, "--help")
    options = options_of(of_window)
    made = {"man/flatfitfab-cli.1.in": cli_page(verbs, help_.strip().splitlines()[-1]),
            "man/flatfitfab.1.in": window_page(of_window)}
    for name, its_verbs, its_options in (("flatfitfab-cli", verbs, None), ("flatfitfab", None, options)):
        made[f"completion/{name}.bash"] = bash(name, its_verbs, its_options)
        made[f"completion/_{name}"] = zsh(name, its_verbs, its_options)
        made[f"completion/{name}.fish"] = fish(name, its_verbs, its_options)
    return {path: "\n".join(lines) + "\n" for path, lines in made.items()}


def main(cli, window, *rest):
    stale = []
    for path, text in pages(cli, window).items():
        file = HERE / path
        if rest == ("--check",):
            if not file.exists() or file.read_text() != text:
                stale.append(path)
        else:
            file.parent.mkdir(exist_ok=True)
            file.write_text(text)
    for path in stale:
        print(f"packaging/linux/{path} is stale: run packaging/linux/pages.py CLI WINDOW")
    return 1 if stale else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
