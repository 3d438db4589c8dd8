/// A name that none of `taken` has: "box", "box_2" ...
export function freeName(wanted: string, taken: readonly string[]): string {
    const stem = wanted.replace(/_\d+$/, '');
    for (let i = 1; ; i += 1) {
        const name = i === 1 ? wanted : `${stem}_${i}`;
        if (!taken.includes(name)) {
            return name;
        }
    }
}
