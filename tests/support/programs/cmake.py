#!/usr/bin/env python3
"""A stand-in for CMake under tools/watch. Its build copies the files $BUILT when tools/watch has printed its step count;
it fails if there are none."""
import os
import re
import shutil
import sys
import time

watch = os.getppid()


def printed():
    with open(f'/proc/{watch}/fd/2') as errors:
        return re.search(r'^building: \[1/2\], \d+ s$', errors.read(), re.M)


if sys.argv[1] == '--build':
    if not os.environ['BUILT']:
        sys.exit('no compiler')
    print('[1/2] half of it', flush=True)
    while os.getppid() == watch and not printed():
        time.sleep(0.1)
    for file in os.environ['BUILT'].split(':'):
        shutil.copy(file, sys.argv[2])
