"""Packed programs under the distribution's kernel, in a machine of qemu with 5-level paging."""
import gzip
import re
import shutil

import pytest

from running import BUILD, PATIENCE, SOURCE, needs, run

pytestmark = pytest.mark.long
needs('gcc', 'qemu-system-x86_64', 'busybox', 'apt-get', 'dpkg')
LINKS = ['', '-no-pie', '-static', '-static-pie']
INIT = '''#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
echo "kernel $(/bin/busybox uname -r), $(/bin/busybox grep -o -m 1 la57 /proc/cpuinfo)"
export SAID=words
for program in /bin/packed* /bin/hello; do $program a word; echo "$program: status $?"; done
/bin/busybox poweroff -f
'''


@pytest.fixture(scope='module')
def kernel(work):
    depends = re.search(r'Depends: (\S+)', run('apt-cache', 'depends', 'linux-image-cloud-amd64', status=None).stdout)
    if not depends or run('apt-get', 'download', depends[1], cwd=work, status=None).returncode:
        pytest.skip('the kernel is not installed, and cannot be downloaded')
    run('dpkg', '-x', *work.glob('linux-image*.deb'), work)
    return next(work.glob('boot/vmlinuz-*'))


@pytest.fixture(scope='module')
def log(work, kernel):
    """What the machine prints. Its processor is emulated, which takes about a minute."""
    root = work / 'root'
    for folder in 'bin', 'proc', 'lib64', 'lib/x86_64-linux-gnu':
        (root / folder).mkdir(parents=True)
    libraries = [f'lib/x86_64-linux-gnu/{name}' for name in ('libc.so.6', 'libdl.so.2')]
    for file in 'bin/busybox', 'lib64/ld-linux-x86-64.so.2', *libraries:
        shutil.copy(f'/{file}', root / file)
    for link in LINKS:
        source = SOURCE / 'tests/support/programs/loaded.c'
        run('gcc', '-O1', '-s', source, *link.split(), '-o', work / 'program')
        run(BUILD / 'pack', work / 'program', '-o', root / f'bin/packed{link}', '--loader', '--fast')
    run('bash', SOURCE / 'packer/example/build.sh', BUILD / 'pack', work)
    shutil.copy(work / 'hello', root / 'bin')
    (root / 'init').write_text(INIT)
    (root / 'init').chmod(0o755)
    names = b'\n'.join(bytes(path.relative_to(root)) for path in root.rglob('*'))
    archive = run('busybox', 'cpio', '-o', '-H', 'newc', input=names, cwd=root, text=False).stdout
    (work / 'initrd').write_bytes(gzip.compress(archive, 1))
    machine = 'qemu-system-x86_64 -M q35 -cpu max,la57=on -m 512 -nographic -no-reboot'.split()
    files = ('-kernel', kernel, '-initrd', work / 'initrd')
    return run(*machine, *files, '-append', 'console=ttyS0 quiet panic=-1', timeout=2 * PATIENCE).stdout


def test_the_kernel_has_5_level_paging(log):
    assert re.search('kernel .*, la57$', log, re.M)


def test_packed_programs_run(log):
    for link in LINKS:
        assert f'\n/bin/packed{link}: status 7\n' in log
    assert log.count("\n3 words, the last 'word'; 43, 1, relative addresses, 0, words\n") == len(LINKS)


def test_a_program_made_for_packing_runs(log):
    assert '\n/bin/hello: status 7\n' in log
