"""Wine, which runs programs for Windows.

It keeps its copy of Windows, about 700 MB, in build/wine; the first test makes it. Only one test file may use it at a
time: ctest sees to that.
"""
import contextlib
import shutil

import pytest

from running import BUILD, Program, needs, redirected, run, wait_for

OVERRIDES = 'mscoree,mshtml=;winemenubuilder.exe=d'


def without(library):
    """The environment in which Wine does not have this library."""
    return {'WINEDLLOVERRIDES': f'{library}=;{OVERRIDES}'}


@contextlib.contextmanager
def started_wine(folder):
    """Yields the path of wine64, while a server of Wine runs.

    Without the server each program would start its own, which would inherit the pipes of the program's output and keep
    them open.
    """
    wine, server = (shutil.which(name) or f'/usr/lib/wine/{name}' for name in ('wine64', 'wineserver64'))
    needs(wine, server)
    copy = BUILD / 'wine'
    copy.mkdir(exist_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        for name, value in {'WINEPREFIX': copy, 'WINEDEBUG': '-all', 'WINEDLLOVERRIDES': OVERRIDES}.items():
            patch.setenv(name, str(value))
        run(server, '-k', status=None)  # the server of an interrupted run, which would show windows on another display
        with Program(folder, server, '-f', '-p'), open(copy / 'wineboot', 'w') as log:
            try:
                # Wine's services outlive these, and would keep a pipe open
                if not (copy / 'system.reg').exists():
                    run(wine, 'wineboot', '-i', stdout=log, stderr=log)
                run(wine, 'cmd', '/c', 'exit', stdout=log, stderr=log)  # starts the services
                yield wine
            finally:
                run(server, '-k', status=None)  # otherwise Wine's device processes would keep the processor busy


def answers_box(display, name, *command, **options):
    """Runs a command without standard error, and closes the message box that it opens, which has this title or is of a
    program of this name. Returns the command's exit status."""
    box = ('xdotool', 'search', '--onlyvisible', name)
    program = display.start(*redirected('2>&-', *command), **options)
    program.comes(lambda: display.run(*box, status=None).stdout)
    wait_for(lambda: display.run(*box, 'windowfocus', 'key', 'Return', status=None) and not program.runs())
    return program.ended()
