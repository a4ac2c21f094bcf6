/** Public API of the npm package `inkpanel`, which `cargo xtask package` makes. */

export type { PlanRequest } from './core.ts';
export type { Block, BlockParam, Layout, PageDocument, PageSettings, Style, Word } from './types.ts';
export type { Call, Engine } from './engine.ts';
export type { PixelPatch } from './protocol.ts';
export type { Detection as Found, PhotoMeta } from './types.ts';

export type { Editor, Planner } from './core.ts';
export type { ProjectEditor } from './project.ts';
export type { SavedProject } from './saved-project.ts';
export type { Difference, Edit, History, Project } from './types.ts';

export { createEngine } from './engine.ts';
export { createProject } from './project.ts';
export { openProject } from './saved-project.ts';
