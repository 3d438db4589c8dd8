/// carom's schema, as the server tells it.
import { withKey } from '../connection/key';
import { signal } from '@preact/signals';
import type { Schema } from './value_types';

/// Null until it has come.
export const schema = signal<Schema | null>(null);

/// Asks for the schema; to be called once.
export async function loadSchema(): Promise<void> {
    const answer = await fetch(withKey('/schema.json'));
    if (answer.ok) {
        schema.value = await answer.json() as Schema;
    }
}
