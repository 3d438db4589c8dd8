import { signal } from '@preact/signals';
import type { EditQuestion } from './edit_types';

/// What an edit asks; null: nothing. src/dialogs shows it.
export const question = signal<EditQuestion | null>(null);
