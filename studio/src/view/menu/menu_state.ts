/// The open menu of the view.
import { signal } from '@preact/signals';

export interface MenuItem {
    label: string;
    run(): void;
    /// Shown at the right: a key, or what the item is about.
    hint?: string;
    /// Of an item that is on or off; such a menu stays open.
    isOn?: boolean;
    isDisabled?: boolean;
    /// A line above the item.
    startsGroup?: boolean;
}

export interface OpenMenu {
    title: string;
    /// CSS pixels of the page.
    x: number;
    y: number;
    /// Called anew whenever a signal that it reads changes.
    items: () => readonly MenuItem[];
}

export const menu = signal<OpenMenu | null>(null);

/// Shows a menu, its upper left corner at a place of the page if it fits there.
export function openMenu(opened: OpenMenu): void {
    menu.value = opened;
}

export function closeMenu(): void {
    menu.value = null;
}
