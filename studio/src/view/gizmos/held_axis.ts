/// Which of the keys x, y and z is held: drags then keep to that axis.
const kAxisKeys = ['x', 'y', 'z'];

let held: number | null = null;
let users = 0;

function down(event: KeyboardEvent): void {
    const axis = kAxisKeys.indexOf(event.key.toLowerCase());
    if (axis >= 0 && !event.ctrlKey && !event.metaKey) {
        held = axis;
    }
}

function up(event: KeyboardEvent): void {
    if (kAxisKeys.indexOf(event.key.toLowerCase()) === held) {
        held = null;
    }
}

function left(): void {
    held = null;
}

/// 0, 1 or 2; null without any.
export function heldAxis(): number | null {
    return held;
}

/// Follows the keys from now on. Returns a function that ends this.
export function followAxisKeys(): () => void {
    const listeners = [['keydown', down], ['keyup', up], ['blur', left]] as const;
    if (users++ === 0) {
        listeners.forEach(([name, listener]) =>
            window.addEventListener(name, listener as EventListener, { capture: true }));
    }
    return () => {
        if (--users === 0) {
            listeners.forEach(([name, listener]) =>
                window.removeEventListener(name, listener as EventListener, { capture: true }));
        }
    };
}
