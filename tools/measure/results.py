"""Reads and writes RESULTS.md. The record of a section is on the line above it: <!-- size: 0123456789ab; ... -->."""
import datetime
import os
import platform
import re
import subprocess

from machine import PROCESSORS, Failed

MARK = re.compile(r'<!-- ([a-z]+)(?:: (.*))? -->')
HEAD = '''# Measured

`tools/measure/all` writes this page. `--only NAME` measures one section, `--stale` the sections whose code has changed;
`--check` lists these. The sections are defined in `sections.py`. Below each title are the day, the commit, the machine,
the number of processors that other programs kept busy (above 0.5, times are too long), and the commands. Times are
processor times of all threads, user and system, unless the column says otherwise. Callgrind counts instructions, which
other programs do not disturb. Where cores are shared, ratios within a run are more reliable than times.

| the last run | |
|---|---|
| day | {day} |
| processor | {processor} |
| memory | {memory:.0f} GB |
| system | {system}, Linux {kernel} |
| compiler | {compiler} |
| Mesa | {mesa} |
'''


def today():
    return datetime.datetime.now(datetime.timezone.utc).strftime('%Y-%m-%d')


def processor():
    return re.search(r'^model name\s*: (.*)', open('/proc/cpuinfo').read(), re.M)[1] + f', {PROCESSORS} cores'


def said(*words):
    try:
        return subprocess.run(words, capture_output=True, text=True).stdout.split('\n')[0]
    except OSError:
        return ''


class Results:
    def __init__(self, path):
        self.path, self.records, self.texts = path, {}, {}
        text = path.read_text() if path.exists() else ''
        marks = [mark for mark in re.finditer(MARK.pattern + r'\n', text)]
        for mark, after in zip(marks, marks[1:] + [None]):
            self.texts[mark[1]] = text[mark.end():after.start() if after else len(text)].strip()
            self.records[mark[1]] = mark[2]

    def write(self, sections):
        head = HEAD.format(
            day=today(), processor=processor(), kernel=platform.release(),
            memory=os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 2**30,
            system=platform.freedesktop_os_release()['PRETTY_NAME'], compiler=said('c++', '--version'),
            mesa=said('dpkg-query', '-W', '-f', '${Version}', 'libgl1-mesa-dri') or "not Debian's")
        part = self.path.with_name(f'.{self.path.name}.part')
        part.write_text(head + ''.join(self.section(section) for section in sections))
        part.replace(self.path)

    def section(self, section):
        if self.records.get(section.name):
            return f'\n<!-- {section.name}: {self.records[section.name]} -->\n{self.texts[section.name]}\n'
        return (f'\n<!-- {section.name} -->\n## {section.title}\n\n'
                f'Not measured yet: `tools/measure/all --only {section.name}`, {section.minutes:g} minutes.\n')

    # --- Its tables ---

    def tables(self, name):
        for block in re.findall(r'(?:^\|.*\n?)+', self.texts.get(name, ''), re.M):
            head, _, *body = [[cell.strip() for cell in line.strip('|').split('|')] for line in block.splitlines()]
            yield head, body

    def column(self, name, column):
        """The cells of a column, keyed by the first cell of the row, from the first table that has the column."""
        for head, body in self.tables(name):
            if column in head:
                at = head.index(column)
                return {line[0]: line[at] for line in body if len(line) > at}
        raise Failed(f"figures: section {name} has no '{column}'")

    def cells(self, name, column, row, count=1):
        """The cells with content below a column, in the rows of all tables that begin with `row`: `count` at least."""
        found = [line[head.index(column)] for head, body in self.tables(name) if column in head
                 for line in body if line[0] == row and line[head.index(column):][:1] not in ([], [''])]
        if len(found) < count:
            raise Failed(f"figures: section {name} has no '{row}' below '{column}'")
        return found

    def cell(self, name, column, row):
        return self.cells(name, column, row)[0]
