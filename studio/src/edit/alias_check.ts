/// Refuses edits that take a value away that an alias repeats.
import { visit } from 'yaml';
import { EditError } from './edit_error';
import type { FileEdits } from './edit_types';
import { applyEdits } from './text_edit';
import { parseTree } from './yaml_tree';

/// The names of the aliases that stand for nothing.
function danglingAliases(text: string): string[] {
    const { document } = parseTree(text);
    const names: string[] = [];
    visit(document, {
        Alias: (_, alias) => {
            if (!alias.resolve(document)) {
                names.push(alias.source);
            }
        },
    });
    return names;
}

/// The edits, unless they take a value away that is repeated elsewhere.
export function checked(plan: FileEdits): FileEdits {
    const { file, edits } = plan;
    if (/(^|[\s,[{])\*[^\s*]/.test(file.text)) {
        const before = danglingAliases(file.text);
        const lost = danglingAliases(applyEdits(file.text, edits))
            .find((name) => !before.includes(name));
        if (lost !== undefined) {
            throw new EditError(`the value is written as '&${lost}' here and repeated by `
                + `'*${lost}' elsewhere, which would have no value`);
        }
    }
    return plan;
}
