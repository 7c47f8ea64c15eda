#!/usr/bin/env python3
"""A stand-in for CMake under tools/watch. Its build copies the files $BUILT when tools/watch has printed its step
count, and that it packs if $PACKS is " packing"; it fails if there are no files."""
import os
import re
import shutil
import sys
import time

watch, packs = os.getppid(), os.environ.get('PACKS', '')


def printed():
    with open(f'/proc/{watch}/fd/2') as errors:
        return re.search(rf'^building: \[1/2\]{packs}, \d+ s$', errors.read(), re.M)


if sys.argv[1] == '--build':
    if not os.environ['BUILT']:
        sys.exit('no compiler')
    with open('/proc/self/comm', 'w') as name:
        name.write('pack_film' if packs else 'cmake')
    print('[1/2] half of it', flush=True)
    while os.getppid() == watch and not printed():
        time.sleep(0.1)
    for file in os.environ['BUILT'].split(':'):
        shutil.copy(file, sys.argv[2])
