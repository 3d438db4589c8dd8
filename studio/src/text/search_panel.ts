/// The panel of Ctrl-F: the word with its three switches, how many there are, and replacing.
import {
    closeSearchPanel, findNext, findPrevious, getSearchQuery, replaceAll, replaceNext, SearchQuery,
    setSearchQuery,
} from '@codemirror/search';
import { runScopeHandlers, type EditorView, type Panel, type ViewUpdate } from '@codemirror/view';

const kMost = 999;  // matches that are counted

type Child = HTMLElement | string;

function element<Tag extends keyof HTMLElementTagNameMap>(
    tag: Tag, attributes: Record<string, string>, ...children: Child[]
): HTMLElementTagNameMap[Tag] {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        made.setAttribute(name, value);
    }
    made.append(...children);
    return made;
}

function button(text: string, title: string, run: () => void, name = 'plain'): HTMLButtonElement {
    const made = element('button',
        { type: 'button', class: `find-button ${name}`, title, 'aria-label': title }, text);
    made.addEventListener('click', run);
    return made;
}

function field(label: string, name: string): HTMLInputElement {
    return element('input', { class: 'find-field', placeholder: label, 'aria-label': label,
        name, spellcheck: 'false', autocomplete: 'off', 'main-field': String(name === 'search') });
}

/// "2 of 12", by the selection.
function countText(view: EditorView, query: SearchQuery): string {
    if (query.search === '' || !query.valid) {
        return '';
    }
    const cursor = query.getCursor(view.state);
    const { from } = view.state.selection.main;
    let count = 0;
    let current = 0;
    for (let one = cursor.next(); !one.done && count < kMost; one = cursor.next()) {
        count += 1;
        current = one.value.from === from ? count : current;
    }
    const all = count === kMost ? `${kMost}+` : String(count);
    return count === 0 ? 'none' : current > 0 ? `${current} of ${all}` : all;
}

class FindPanel implements Panel {
    readonly dom: HTMLElement;
    readonly top = true;
    private readonly search = field('Find', 'search');
    private readonly replace = field('Replace with', 'replace');
    private readonly count = element('span', { class: 'find-count', 'aria-live': 'polite' });
    private readonly switches: Record<'caseSensitive' | 'wholeWord' | 'regexp', HTMLButtonElement>;
    private query: SearchQuery;

    constructor(private readonly view: EditorView) {
        this.query = getSearchQuery(view.state);
        const toggle = (key: keyof FindPanel['switches'], text: string, title: string) =>
            button(text, title, () => {
                const made = this.switches[key];
                made.setAttribute('aria-pressed', String(made.getAttribute('aria-pressed') !== 'true'));
                this.commit();
            }, 'switch');
        this.switches = {
            caseSensitive: toggle('caseSensitive', 'Aa', 'Match case'),
            wholeWord: toggle('wholeWord', 'W', 'Whole words'),
            regexp: toggle('regexp', '.*', 'Regular expression'),
        };
        const isLocked = view.state.readOnly;
        const { caseSensitive, wholeWord, regexp } = this.switches;
        this.dom = element('div', { class: 'find', role: 'search' },
            element('div', { class: 'find-row' },
                element('div', { class: 'find-box' }, this.search, this.count, caseSensitive,
                    wholeWord, regexp),
                button('↑', 'Previous (Shift+Enter)', () => findPrevious(view)),
                button('↓', 'Next (Enter)', () => findNext(view)),
                button('×', 'Close (Escape)', () => closeSearchPanel(view))),
            ...isLocked ? [] : [element('div', { class: 'find-row' },
                element('div', { class: 'find-box' }, this.replace),
                button('Replace', 'Replace this one (Enter)', () => replaceNext(view), 'wide'),
                button('All', 'Replace all', () => replaceAll(view), 'wide'))]);
        this.search.addEventListener('input', () => this.commit());
        this.replace.addEventListener('input', () => this.commit());
        this.dom.addEventListener('keydown', (event) => this.press(event));
        this.show(this.query);
    }

    mount(): void {
        this.search.select();
    }

    update(update: ViewUpdate): void {
        const query = getSearchQuery(update.state);
        if (!query.eq(this.query)) {
            this.show(query);
        } else if (update.docChanged || update.selectionSet) {
            this.count.textContent = countText(update.view, query);
        }
    }

    private show(query: SearchQuery): void {
        this.query = query;
        this.search.value = query.search;
        this.replace.value = query.replace;
        for (const key of ['caseSensitive', 'wholeWord', 'regexp'] as const) {
            this.switches[key].setAttribute('aria-pressed', String(query[key]));
        }
        this.count.textContent = countText(this.view, query);
        this.dom.classList.toggle('wrong', query.search !== '' && !query.valid);
    }

    private commit(): void {
        const isOn = (key: keyof FindPanel['switches']) =>
            this.switches[key].getAttribute('aria-pressed') === 'true';
        const query = new SearchQuery({
            search: this.search.value, replace: this.replace.value, literal: !isOn('regexp'),
            caseSensitive: isOn('caseSensitive'), wholeWord: isOn('wholeWord'),
            regexp: isOn('regexp'),
        });
        if (!query.eq(this.query)) {
            this.view.dispatch({ effects: setSearchQuery.of(query) });
            this.show(query);
        }
    }

    private press(event: KeyboardEvent): void {
        if (runScopeHandlers(this.view, event, 'search-panel')) {
            event.preventDefault();
        } else if (event.key === 'Enter' && event.target === this.search) {
            event.preventDefault();
            (event.shiftKey ? findPrevious : findNext)(this.view);
        } else if (event.key === 'Enter' && event.target === this.replace) {
            event.preventDefault();
            replaceNext(this.view);
        }
    }
}

/// Makes the panel for CodeMirror's search.
export function findPanel(view: EditorView): Panel {
    return new FindPanel(view);
}
