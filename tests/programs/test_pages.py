"""The links of the pages lead to files that exist."""
import re

from running import SOURCE, run


def dead_links(pages):
    links = [(page, link) for page in pages for link in re.findall(r'\]\((?!https?:)([^)#]+)', page.read_text())]
    assert links
    return [f'{page}: {link}' for page, link in links if not (page.parent / link).exists()]


def test_no_link_is_dead():
    pages = run('git', 'ls-files', '*.md', ':!tools/film_template', cwd=SOURCE).stdout.splitlines()
    assert not dead_links(SOURCE / page for page in pages)


def test_a_dead_link_would_be_found(tmp_path):
    page = tmp_path / 'wrong.md'
    page.write_text('[a](nothing.md)')
    assert dead_links([page]) == [f'{page}: nothing.md']
