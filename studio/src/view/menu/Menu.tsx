/// A menu over the page, for the pointer and the keyboard.
import { Check } from 'lucide-preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { onCommand } from '../../state/keys';
import { closeMenu, menu, type MenuItem, type OpenMenu } from './menu_state';
import './menu.css';

const kEdge = 6; // CSS pixels between the menu and the window's edge

function buttonsOf(list: HTMLElement | null): HTMLButtonElement[] {
    return [...list?.querySelectorAll<HTMLButtonElement>('button:not(:disabled)') ?? []];
}

/// The item that a key leads to: by arrows, the ends, or the first letter; undefined if none.
function destination(list: HTMLElement | null, key: string): HTMLButtonElement | undefined {
    const buttons = buttonsOf(list);
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const count = buttons.length;
    switch (key) {
        case 'ArrowDown': return buttons[(at + 1) % count];
        case 'ArrowUp': return buttons[(Math.max(at, 0) + count - 1) % count];
        case 'Home': return buttons[0];
        case 'End': return buttons[count - 1];
        default:
            return key.length !== 1 || key === ' ' ? undefined
                : [...buttons.slice(at + 1), ...buttons.slice(0, at + 1)].find((button) =>
                    button.textContent?.trim().toLowerCase().startsWith(key.toLowerCase()));
    }
}

function Item({ item }: { item: MenuItem }) {
    const isCheck = item.isOn !== undefined;
    const run = () => {
        if (!isCheck) {
            closeMenu();
        }
        item.run();
    };
    return (
        <>
            {item.startsGroup ? <hr /> : null}
            <button type="button" role={isCheck ? 'menuitemcheckbox' : 'menuitem'}
                aria-checked={isCheck ? item.isOn : undefined} disabled={item.isDisabled}
                tabIndex={-1} onClick={run}
                onPointerMove={(event) => event.currentTarget.focus({ preventScroll: true })}>
                {isCheck ? (
                    <span class="check">{item.isOn
                        ? <Check size={14} aria-hidden="true" /> : null}</span>
                ) : null}
                <span class="label">{item.label}</span>
                {item.hint ? <span class="hint">{item.hint}</span> : null}
            </button>
        </>
    );
}

function Opened({ opened }: { opened: OpenMenu }) {
    const list = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        const element = list.current;
        if (element) {
            const { width, height } = element.getBoundingClientRect();
            const left = Math.min(opened.x, innerWidth - width - kEdge);
            const top = Math.min(opened.y, innerHeight - height - kEdge);
            element.style.left = `${Math.max(kEdge, left)}px`;
            element.style.top = `${Math.max(kEdge, top)}px`;
        }
        const before = document.activeElement;
        buttonsOf(list.current)[0]?.focus({ preventScroll: true });
        const forgetCancel = onCommand('cancel', closeMenu); // wherever the focus is
        const outside = (event: Event) => {
            if (!list.current?.contains(event.target as Node)) {
                closeMenu();
            }
        };
        addEventListener('pointerdown', outside, { capture: true });
        addEventListener('wheel', outside, { capture: true, passive: true });
        addEventListener('blur', closeMenu);
        return () => {
            forgetCancel();
            removeEventListener('pointerdown', outside, { capture: true });
            removeEventListener('wheel', outside, { capture: true });
            removeEventListener('blur', closeMenu);
            if (before instanceof HTMLElement && document.activeElement === document.body) {
                before.focus({ preventScroll: true });
            }
        };
    }, [opened]);
    const key = (event: KeyboardEvent) => {
        event.stopPropagation();
        if (event.key === 'Escape' || event.key === 'Tab') {
            event.preventDefault();
            closeMenu();
            return;
        }
        const button = destination(list.current, event.key);
        if (button) {
            event.preventDefault();
            button.focus({ preventScroll: true });
        }
    };
    return (
        <div class="menu" role="menu" aria-label={opened.title} ref={list} onKeyDown={key}
            onContextMenu={(event) => event.preventDefault()}>
            <p class="title" aria-hidden="true">{opened.title}</p>
            {opened.items().map((item) => <Item key={item.label} item={item} />)}
        </div>
    );
}

/// The open menu, if there is one.
export function Menu() {
    return menu.value ? <Opened opened={menu.value} /> : null;
}
