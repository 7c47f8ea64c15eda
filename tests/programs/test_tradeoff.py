"""Small runs of `tradeoff` and `bench_pack`, which measure the tracer's and the packer's speed and accuracy: with one
scene, in a long run with all."""
import pytest

from running import BUILD, SOURCE, needs, needs_built, refuses, rows_of, run

needs_built('tradeoff', 'bench_pack')
needs('g++', 'objcopy')

TRADEOFF, BENCH = BUILD / 'tradeoff', BUILD / 'bench_pack'
COLUMNS = ['scene', 'setting', 'samples_per_pixel', 'cpu_ms', 'mean_flip', 'linear_psnr_db', 'srgb_psnr_db']


def table(folder, program, *options):
    """The rows that a program prints."""
    (folder / 'csv').write_text(run(program, *options).stdout)
    return rows_of(folder / 'csv')


# In field, draft and play take the same samples
@pytest.mark.parametrize('scenes, compared', [
    ('A', 'A'),
    pytest.param('A B field point table flake patches hall odraz credits', 'A B table flake hall',
                 marks=pytest.mark.long)])
def test_each_quality_is_nearer_to_the_reference_than_the_one_below(scenes, compared, tmp_path):
    rows = table(tmp_path, TRADEOFF, '--width', 256, *(['--scene', 'A'] if scenes == 'A' else []))
    assert [*rows[0]] == COLUMNS
    qualities = {(row['scene'], row['setting']): row for row in rows}
    assert qualities.keys() == {(scene, name) for scene in scenes.split() for name in ('draft', 'play', 'film')}
    for scene in compared.split():
        draft, play, film = (qualities[scene, name] for name in ('draft', 'play', 'film'))
        assert draft['mean_flip'] > play['mean_flip'] > film['mean_flip'], scene
        assert draft['linear_psnr_db'] < play['linear_psnr_db'] < film['linear_psnr_db'], scene
        assert draft['srgb_psnr_db'] < play['srgb_psnr_db'] < film['srgb_psnr_db'], scene


def test_knobs_change_the_samples(tmp_path):
    settings = '--setting play --setting play,grid=2,cutoff=0.015 --setting level=1.5'.split()
    rows = table(tmp_path, TRADEOFF, '--width', 256, '--rounds', 1, '--scene', 'credits', *settings)
    samples = {row['setting']: row['samples_per_pixel'] for row in rows}
    assert samples['play grid=2 cutoff=0.015'] == 4
    assert samples['level=1.5'] < samples['play']


def packed(folder, *options):
    """What bench_pack measures of a file."""
    (row,) = table(folder, BENCH, *options)
    return row


def test_a_program_is_packed_other_contexts_are_hardly_better_and_instructions_alone_are_packed(tmp_path):
    # The example of a few hundred bytes, since the film takes a second
    run('bash', SOURCE / 'packer/example/build.sh', BUILD / 'pack', tmp_path)
    program = tmp_path / 'hello.elf'
    row = packed(tmp_path, program)
    assert [*row] == ['bytes', 'payload', 'encode_s', 'decode_kb_s', 'memory_mb']
    assert row['payload'] < (tmp_path / 'hello').stat().st_size  # by its headers
    packed(tmp_path, '--contexts', 4, '--slots', 16, program)
    assert row['payload'] < packed(tmp_path, '--arbitrary', '--search', 0.2, program)['payload'] + 40
    refuses(2, 'a multiple of 4', BENCH, '--contexts', 5, program)
    run('objcopy', '-O', 'binary', '-j', '.text', BUILD / 'pack', tmp_path / 'code')
    (tmp_path / 'sample').write_bytes((tmp_path / 'code').read_bytes()[:4096])
    assert packed(tmp_path, tmp_path / 'sample')['bytes'] == 4096


@pytest.mark.parametrize('setting, text', [
    ('play,colour=1', "unknown knob 'colour': use one of grid"),
    ('fine', "unknown quality 'fine'"),
    ('level=3', 'level')])
def test_refuses_an_invalid_setting(setting, text):
    refuses(2, text, TRADEOFF, '--setting', setting)
