"""The links of the pages, and the steps of workflows, name files that exist; the keys of the pages are in the table."""
import re

from running import SOURCE, run


def dead_links(pages):
    links = [(page, link) for page in pages for link in re.findall(r'\]\((?!https?:)([^)#]+)', page.read_text())]
    assert links
    return [f'{page}: {link}' for page, link in links if not (page.parent / link).exists()]


def test_no_link_is_dead(tmp_path):
    pages = run('git', 'ls-files', '*.md', ':!tools/film_template', cwd=SOURCE).stdout.splitlines()
    assert not dead_links(SOURCE / page for page in pages)
    page = tmp_path / 'wrong.md'
    page.write_text('[a](nothing.md)')
    assert dead_links([page]) == [f'{page}: nothing.md']


def test_the_steps_of_workflows_name_files_that_exist():
    scripts = *SOURCE.glob('.github/workflows/*.yml'), SOURCE / '.ci/run', SOURCE / '.devcontainer/devcontainer.json'
    named = {name for script in scripts for name in re.findall(r'\b(?:intro|tools|tests)/[\w./]+', script.read_text())}
    assert {'tools/test', 'tools/release', 'tools/ledger', 'tools/build/packages.sh', 'intro/film.conf'} <= named
    assert not [name for name in named if not (SOURCE / name).exists()]


def unknown_keys(text):
    """The single letters in code, which are keys of odraz-debug, that its table does not list."""
    table = re.findall(r'^    {Action.*?"(.*?)"', (SOURCE / 'intro/maker/panel/keys.h').read_text(), re.M)
    named = set(re.findall(r'`([A-Z])`', text))
    assert named
    return named - set(re.findall(r'\b[A-Z]\b', ' '.join(table)))


def test_every_key_that_a_page_names_is_one():
    pages = (SOURCE / folder / 'show/README.md' for folder in ('intro', 'tools/film_template'))
    assert not unknown_keys(''.join(page.read_text() for page in pages if page.exists()))
    assert unknown_keys('`G` shows the path from outside, `K` sets a key') == {'G'}
