/// Questions that an edit may raise, and what the user has answered.
import type { Alias } from 'yaml';
import type { SourceFile } from './edit_types';
import type { TextEdit } from './text_edit';
import { flowText } from './write_value';
import { rangeOf, type Step, type Tree } from './yaml_tree';

export type AliasDecision = 'anchor' | 'copy';

/// What the user has decided about values that could be changed in two ways.
export interface Decisions {
    /// Values of includes are changed in the include, not laid over in the shot.
    intoInclude?: boolean;
    /// What to do with aliases, by the `aliasKey` of their anchor.
    aliases?: ReadonlyMap<string, AliasDecision>;
}

/// A question that has to be answered before the edit is possible.
export class Undecided extends Error {
    constructor(
        message: string,
        readonly kind: 'alias' | 'list',
        /// The `aliasKey` of the anchor, or the path of the list joined with "/".
        readonly subject: string,
        /// The name of the anchor, or the list as it is shown.
        readonly shown: string,
    ) {
        super(message);
    }
}

/// What an anchor is remembered by: files may use the same names.
export function aliasKey(file: string, anchor: string): string {
    return `${file}&${anchor}`;
}

/// What is to be done with an alias. Throws Undecided if nobody has said that.
export function decisionOf(file: SourceFile, alias: Alias, decisions: Decisions): AliasDecision {
    const { source } = alias;
    const key = aliasKey(file.file, source);
    const decision = decisions.aliases?.get(key);
    if (decision === undefined) {
        throw new Undecided(
            `'*${source}' repeats a value that is written elsewhere with the name '&${source}'.`,
            'alias', key, source);
    }
    return decision;
}

/// Follows the outermost alias on the way if the user wants the anchor changed, or puts a copy of
/// the value in its place. Returns the edit that copies, or null if the way can be used as it is.
export function resolveAlias(
    file: SourceFile, tree: Tree, steps: readonly Step[], decisions: Decisions,
): TextEdit | null {
    const alias = steps.find((step) => step.alias !== null)?.alias;
    if (!alias || decisionOf(file, alias, decisions) === 'anchor') {
        return null;
    }
    const [from, to] = rangeOf(alias);
    return { from, to, insert: flowText(tree, alias) };
}
