"""Counts instructions by callgrind, on one thread. Other programs on the machine do not disturb the counts."""
import re

from machine import at_once, say

# Parts of a picture: the function to count, and the command of trace_once that calls it. There are two runs: one poses
# the scene without callgrind, under which the hall would take half an hour; the other is counted.
PARTS = {
    'posing': ('odraz::measure::poseSubject*', 'again'),
    'trace': ('odraz::forTiles*', 'trace'),
    'glare': ('odraz::spreadGlare*', 'develop'),
    'development': ('odraz::develop(*const&)', 'develop'),
}


def spent(machine, command, of=None):
    """The instructions of a program, or of its function `of` with all functions that it calls."""
    only = ['--collect-atstart=no', f'--toggle-collect={of}'] if of else []
    # The shell redirects the report, which is on stderr
    words = ['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', *only, *machine.words(command)]
    printed = machine.run(['sh', '-c', 'exec "$@" 2>&1', 'sh', *words], noted=False)
    return int(re.search(r'Collected : (\d+)', printed)[1])


def posed(machine, scene, size, program='build/trace_once'):
    """The file of a posed scene, which is made once."""
    kept = machine.work / f'{scene}-{size}-{program.replace("/", "-")}'
    if not kept.exists():
        machine.run([program, 'pose', kept, scene, '--size', size], noted=False)
    return kept


def counted(machine, kept, part, setting=None, program='build/trace_once'):
    """The instructions of a part of a posed picture. `setting` is for tracing alone."""
    of, how = PARTS[part]
    return spent(machine, [program, how, kept, *([setting] if part == 'trace' else [])], of)


def pictures(machine, scenes, settings, size, parts=(), program='build/trace_once'):
    """Rows (scene, part or setting, instructions)."""
    files = {scene: posed(machine, scene, size, program) for scene in scenes}
    asked = [(scene, 'trace', setting) for scene in scenes for setting in settings]
    asked += [(scene, part, part) for scene in scenes for part in parts]
    say(f'counting instructions of {len(asked)} pictures')
    counts = at_once(lambda a: counted(machine, files[a[0]], a[1], a[2], program), asked)
    return [(scene, name, count) for (scene, _, name), count in zip(asked, counts)]
