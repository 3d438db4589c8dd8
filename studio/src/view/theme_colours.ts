/// The page's colours for the view, which change with the theme.
import { signal, type ReadonlySignal } from '@preact/signals';
import { readColours, type Colours } from '../strip/colours';

export interface ViewColours extends Colours {
    target: string;
    light: string;
    danger: string;
}

function read(): ViewColours {
    const style = getComputedStyle(document.documentElement);
    const of = (name: string) => style.getPropertyValue(`--${name}`).trim();
    return {
        ...readColours(document.documentElement),
        target: of('target'), light: of('light'), danger: of('danger'),
    };
}

const current = signal<ViewColours | null>(null);

/// The colours of the present theme.
export function viewColours(): ReadonlySignal<ViewColours> {
    if (!current.peek()) {
        current.value = read();
        new MutationObserver(() => { current.value = read(); })
            .observe(document.documentElement, { attributeFilter: ['data-theme'] });
    }
    return current as ReadonlySignal<ViewColours>;
}
