// Starts the page, with its head and budget.
function showTip(event, text = '') {
    $('tip').textContent = text;
    if (!text) return;
    const {offsetWidth, offsetHeight} = $('tip'), {clientX: x, clientY: y} = event;
    $('tip').style.left = `${Math.max(0, Math.min(x + 14, innerWidth - offsetWidth - 4))}px`;
    $('tip').style.top = `${y + 18 + offsetHeight > innerHeight ? y - offsetHeight - 8 : y + 18}px`;
}

// Shows textOf(event) next to the mouse while it is over an element.
function showTips(id, textOf) {
    $(id).onmousemove = event => showTip(event, textOf(event));
    $(id).onmouseleave = () => showTip();
}

function showHead() {
    document.title = `${report.name}: ${number(report.file)} bytes`;
    $('name').textContent = report.name;
    $('size').textContent = `${number(report.file)} bytes`;
    if (report.before) {
        const change = report.file - report.before.file;
        $('change').textContent =
            `${signed(change)} (${signed(100 * change / report.before.file, 2)} %) since ${report.before.name}`;
        $('change').className = change > 0 ? 'more' : change < 0 ? 'less' : 'soft';
    }
    if (report.budget >= 0) {
        const left = report.budget - report.file;
        $('left').textContent = left < 0 ? `over budget by ${number(-left)} bytes of ${number(report.budget)}` :
                                           `${number(left)} bytes left of ${number(report.budget)}`;
        $('left').className = left < 0 ? 'more' : 'less';
    }
}

// Shows rooms, or sections, as parts of the budget.
function showBudget() {
    const all = Math.max(report.file, report.budget), rows = report.rooms.length ? report.rooms : report.sections;
    const sorted = rows.filter(row => row.units > 0).sort((a, b) => b.units - a.units);
    sorted.forEach((row, i) => {
        const wide = inBytes(row.units) / all > 0.04;
        const colour = row.name.startsWith('(') ? '#8791a0' : `hsl(${(205 + 47 * i) % 360} 38% 64%)`;
        $('budget').append(make('div', wide ? `${row.name} ${number(inBytes(row.units))}` : '', '', {
            style: `width:${100 * inBytes(row.units) / all}%;background:${colour}`,
            title: `${row.name}: ${number(inBytes(row.units), 1)} bytes`
        }));
    });
    const left = report.budget - report.file;
    if (left > 0)
        $('budget').append(make('div', left / all > 0.04 ? `${number(left)} left` : '', 'free'));
    else if (left < 0 && report.budget >= 0)
        $('budget').append(make('div', '', 'over', {style: `left:${100 * report.budget / all}%`, title: 'the budget'}));
}

// Goes to the address after # in the page's URL, such as #404a10, or else to the costliest symbol.
function goToHash() {
    const at = parseInt(location.hash.slice(1), 16) - report.base;
    if (at >= 0 && at < bytes.length) return goTo(at);
    const costliest = report.symbols.reduce(
        (a, b) => b.stretches.length && !b.name.startsWith('(n') && !(a?.units > b.units) ? b : a, null);
    goTo(costliest?.stretches[0].begin ?? 0);
}

async function start() {
    if (!window.DecompressionStream) throw new Error('this browser is too old: it lacks DecompressionStream');
    await readData();
    const wrong = wrongSums();
    if (wrong.length) $('problem').textContent = `These do not add up to the file: ${wrong.join(', ')}.`;
    showHead();
    showBudget();
    startTables();
    startTree();
    startListing();
    startHeat();
    goToHash();
    window.onhashchange = goToHash;
    window.onresize = () => {
        showTree();
        layHeat();
        showListing();
    };
    document.body.dataset.ready = wrong.length ? 'wrong' : 'yes';
}
start().catch(error => {
    $('problem').textContent = `This page cannot be shown: ${error.message}`;
});
