/// Whether a field has its own undo: one that is typed into has, until its text is taken over or left.

type Field = HTMLInputElement | HTMLTextAreaElement;

let typed: { field: Field; before: string } | null = null;

function isField(target: EventTarget | null): target is Field {
    return target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement;
}

/// Whether undo in an element is the element's own: of an editor, or of a field with a draft.
export function hasOwnUndo(element: Element): boolean {
    if (element.closest('[contenteditable]')) {
        return true;
    }
    return typed !== null && typed.field === element && typed.field.value !== typed.before;
}

/// Takes note of what is typed on the whole page. Returns a function that ends this.
export function watchDrafts(): () => void {
    const begin = ({ target }: Event) => {
        if (isField(target) && typed?.field !== target) {
            typed = { field: target, before: target.value };
        }
    };
    const end = ({ target }: Event) => {
        typed = typed?.field === target ? null : typed;
    };
    window.addEventListener('beforeinput', begin, true);
    window.addEventListener('change', end, true);
    window.addEventListener('focusout', end, true);
    return () => {
        window.removeEventListener('beforeinput', begin, true);
        window.removeEventListener('change', end, true);
        window.removeEventListener('focusout', end, true);
    };
}
