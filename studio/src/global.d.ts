/// Files that esbuild turns into texts, and names that it fills in.
declare module '*.svg' {
    const text: string;
    export default text;
}
declare module '*.css';
/// The folder of the repository, in unit tests.
declare const __REPOSITORY__: string;
