/// A dialog over the page: the rest of the page is inert until it is closed, Escape and a click
/// beside it close it, and the focus returns to where it was.
import { X } from 'lucide-preact';
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef } from 'preact/hooks';
import './dialog.css';

/// A button below the dialog.
export interface DialogAction {
    label: string;
    /// What it does; the dialog closes afterwards unless this returns false.
    run(): void | boolean;
    /// `primary` is the one that Enter gives; `danger` loses something.
    kind?: 'primary' | 'danger' | 'plain';
    isDisabled?: boolean;
    /// A sentence that is shown over the button.
    about?: string;
}

interface Properties {
    title: string;
    actions?: readonly DialogAction[];
    /// Called when the dialog is closed, by a button or without one.
    onClose(): void;
    /// Called instead of `onClose` by Escape, the cross, or a click beside the dialog.
    onDismiss?: (() => void) | undefined;
    /// `wide` for two texts beside each other, `full` for most of the window.
    size?: 'small' | 'wide' | 'full';
    children?: ComponentChildren;
}

/// Closes a dialog by a click that begins and ends beside it.
function closeBeside(dialog: HTMLDialogElement, dismiss: () => void): () => void {
    let isBeside = false;
    const press = (event: PointerEvent) => { isBeside = event.target === dialog; };
    const click = (event: MouseEvent) => {
        if (isBeside && event.target === dialog) {
            dismiss();
        }
    };
    dialog.addEventListener('pointerdown', press);
    dialog.addEventListener('click', click);
    return () => {
        dialog.removeEventListener('pointerdown', press);
        dialog.removeEventListener('click', click);
    };
}

/// The page's own keys do nothing meanwhile, and the browser does not save the page.
function keepKeys(event: KeyboardEvent): void {
    event.stopPropagation();
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 's') {
        event.preventDefault();
    }
}

/// A titled dialog with buttons. The first element with the attribute data-focus gets the focus;
/// without one, the primary button does.
export function Dialog({
    title, actions = [], onClose, onDismiss, size = 'small', children,
}: Properties) {
    const element = useRef<HTMLDialogElement>(null);
    const id = useId();
    const dismiss = onDismiss ?? onClose;
    useEffect(() => {
        const dialog = element.current;
        if (!dialog) {
            return undefined;
        }
        dialog.showModal();
        const first = dialog.querySelector<HTMLElement>('[data-focus]')
            ?? dialog.querySelector<HTMLElement>('.action.primary');
        first?.focus();
        const stop = closeBeside(dialog, dismiss);
        return () => {
            stop();
            dialog.close();
        };
    }, []);
    useEffect(() => {
        // The focus does not leave the dialog when the button that had it is gone.
        if (document.activeElement === document.body) {
            element.current?.querySelector<HTMLElement>('.action:not(:disabled)')?.focus();
        }
    });
    const run = (action: DialogAction) => {
        if (action.run() !== false) {
            onClose();
        }
    };
    const submit = () => {
        const primary = actions.find(({ kind }) => kind === 'primary');
        if (primary && !primary.isDisabled) {
            run(primary);
        }
    };
    return (
        <dialog
            ref={element}
            class={`dialog ${size}`}
            aria-labelledby={id}
            onCancel={(event) => { event.preventDefault(); dismiss(); }}
            onKeyDown={keepKeys}
        >
            <form method="dialog" onSubmit={(event) => { event.preventDefault(); submit(); }}>
                <div class="head">
                    <h2 id={id}>{title}</h2>
                    <button type="button" class="close" aria-label="Dismiss" onClick={dismiss}>
                        <X size={16} aria-hidden="true" />
                    </button>
                </div>
                <div class="body">{children}</div>
                {actions.length === 0 ? null : (
                    <div class="actions">
                        {actions.map((action) => (
                            <button
                                key={action.label}
                                type={action.kind === 'primary' ? 'submit' : 'button'}
                                class={`action ${action.kind ?? 'plain'}`}
                                title={action.about}
                                disabled={action.isDisabled}
                                onClick={action.kind === 'primary' ? undefined : () => run(action)}
                            >
                                {action.label}
                            </button>
                        ))}
                    </div>
                )}
            </form>
        </dialog>
    );
}
