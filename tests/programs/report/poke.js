// Runs in the page: uses it as readers do, and writes the results into <body data-checked data-failed>.
(async () => {
    while (!document.body.dataset.ready) await new Promise(done => setTimeout(done, 10));
    const failed = [];
    let checked = 0;
    const check = (what, there) => {
        ++checked;
        if (!there) failed.push(what);
    };
    const shows = (id, text) => $(id).textContent.startsWith(text);
    const boxes = () => [...$('map').children];
    const filter = text => {
        $('filter').value = text;
        $('filter').oninput();
    };
    const header = () => $('table').querySelector('th button');
    const size = report.file.toLocaleString('en');
    const press = (element, key) => element.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
    const tab = name => [...$('tabs').children].find(b => b.textContent === name);
    const cells = n => [...$('table').querySelectorAll(`tbody tr td:nth-child(${n})`)].map(c => c.textContent);

    check('all adds up', document.body.dataset.ready === 'yes' && !$('problem').textContent);
    check('the size is shown', $('size').textContent === `${size} bytes`);
    check('the change is shown', /since size_ledger.json/.test($('change').textContent));
    check('the budget has parts for rooms', $('budget').children.length > 10);

    // Tables
    check('rooms come first', tab('rooms').getAttribute('aria-selected') === 'true');
    for (const name of ['files', 'symbols', 'sections', 'instructions', 'rooms']) {
        tab(name).click();
        const last = $('table').querySelector('tfoot').textContent;
        check(`${name}: the last line is the file`, last.startsWith('the file') && last.includes(`${size}.0`));
    }
    tab('symbols').click();
    const packed = cells(2).map(text => parseFloat(text.replace(/,/g, '')));
    const falls = packed.every((value, i) => !i || value <= packed[i - 1]);
    check('symbols: the costliest first', packed.length > 100 && falls);
    header().click();
    const sorted = (name, i, all) => !i || all[i - 1].toLowerCase() <= name.toLowerCase();
    check('a click sorts by name', cells(1).every(sorted));
    header().click();
    check('... and the other way', cells(1)[0].toLowerCase() > cells(1)[1].toLowerCase());
    filter('adaptive');
    check('the filter works', cells(1).length > 0 && cells(1).every(name => /adaptive/i.test(name)));
    filter('');

    // Treemap
    const count = boxes().length;
    check('the map has many boxes', count > 100);
    press(boxes().find(box => box.node.name === 'trace'), 'Enter');
    check('Enter zooms in', shownNode.name === 'trace' && shows('chosen', 'trace:'));
    check('... and its files fill the map', boxes().some(box => box.node.name === 'adaptive.cpp.o'));
    press($('map').firstChild, 'Escape');
    check('Escape zooms out', shownNode === root && boxes().length === count);
    const leaf = boxes().find(box => !box.node.children.length && box.node.stretches.length);
    leaf.click();
    const named = shows('chosen', `${leaf.node.name}:`);
    check('a click on a part shows its bytes', named && cursor === leaf.node.stretches[0].begin);
    $('byChange').click();
    check('colours by change', $('byChange').getAttribute('aria-pressed') === 'true');

    // All bytes
    $('heat').scrollTop = 0;
    const box = $('heat').getBoundingClientRect(),
          mouse = {clientX: box.left + gutter + 20.5 * cell, clientY: box.top + 10.5 * cell, bubbles: true};
    $('heat').dispatchEvent(new MouseEvent('mousemove', mouse));
    check('the mouse shows a byte', shows('tip', `${address(10 * columnCount + 20)}: `));
    $('heat').dispatchEvent(new MouseEvent('click', mouse));
    const isListed = () => $('lines').querySelector('.cursor')?.at === cursor;
    check('a click goes there', cursor === 10 * columnCount + 20 && isListed());
    press($('heat'), 'ArrowRight');
    press($('heat'), 'ArrowDown');
    check('arrow keys move', cursor === 11 * columnCount + 21);
    press($('heat'), 'Escape');
    check('Escape shows all', !chosen && $('nothing').hidden);
    press($('heat'), 'End');
    check('the last byte is in the listing', cursor === bytes.length - 1 && isListed());
    const pixels = new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data);
    check('the cells have colours', pixels.size > 50);

    // Listing
    $('find').value = 'odrazMain';
    press($('find'), 'Enter');
    const here = $('lines').querySelector('.here');
    check('a name is found', here && /^odrazMain(\(int, char\*\*\))?$/.test(locationOf(cursor)));
    location.hash = `#${address(instructions[1000].at)}`;
    await new Promise(done => setTimeout(done, 50));
    check('an address in the link is found', cursor === instructions[1000].at);
    const all = new Set(lineAt);
    check('lines are in order', lineAt.every((at, i) => !i || at >= lineAt[i - 1]));
    check('every instruction has its line', instructions.every(({at}) => all.has(at)));
    // For comparison with objdump
    const texts = instructions.map(({at, text}) => `${address(at)} ${text}`);
    document.body.append(make('pre', texts.join('\n'), 'instructions'));
    document.body.dataset.checked = checked;
    document.body.dataset.failed = failed.join('; ');
})().catch(error => {
    document.body.dataset.failed = `${error}`;
});
