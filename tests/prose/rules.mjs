/**
 * Patterns of unclear English, each with a sentence that it finds and one that it does not: `check.mjs` tries both at every run.
 *
 * A pattern is matched against one sentence. Inline code is `code` by then, and links are their text.
 */

/** Longest sentence in words: in Markdown, and in comments and strings. */
export const LONGEST = { markdown: 25, other: 32 };

/** Start of a sentence or of a clause after a colon or a semicolon. */
const START = String.raw`(?:^|[:;(] ?)`;
/** Units that "per" belongs to. */
const UNITS =
  'second|minute|hour|day|inch|page|panel|file|language|photo|picture|frame|shot|layout|style|block|row|column|line|cell|side|core|worker|thread|letter|entry|test|run|cut|sheet|album|folder|pixel|channel';

/** @type {{ id: string, find: RegExp, advice: string, bad: string, good: string }[]} */
export const RULES = [
  {
    id: 'what-subject',
    find: new RegExp(`${START}(?:[A-Z][a-z]+ )?[Ww]hat (?!if\\b)[^?]*$`, 'u'),
    advice: 'name the thing with a noun and make it the subject',
    bad: 'What stays is locked.',
    good: 'Locked panels keep their photos.',
  },
  {
    id: 'what-object',
    find: /\b(?:of|with|by|from|as|than|over|in|for|but|only|except|beyond|without) what (?!if\b)\w+|\b(?:and|or|to|on) what (?:is|was|are|were|it|they|has|had|comes?|stays?|goes|becomes?|needs?|no|else)\b/iu,
    advice: 'name the thing with a noun instead of a "what" clause',
    bad: 'The page is made of what was found.',
    good: 'The page uses the detected faces.',
  },
  {
    id: 'told',
    find: /\btold\b/iu,
    advice: 'write reported, listed, defined, stored, passed or distinguished',
    bad: 'The reason is told on standard error.',
    good: 'The reason is printed to standard error.',
  },
  {
    id: 'tell',
    find: /\btells? (?:of|apart|all|them|each|more|it|what|which|where|whether|how|the (?:rest|same|difference))\b/iu,
    advice: 'write describe, report, print, show or return',
    bad: 'The table tells which files are there.',
    good: 'The table lists the files.',
  },
  {
    id: 'let-go',
    find: /\b(?:lets?|letting) (?:(?:\w+ ){0,3})go(?:es)?\b/iu,
    advice: 'write release, free, unload or close',
    bad: 'The pool lets go of the worker.',
    good: 'The pool terminates the worker.',
  },
  {
    id: 'given-up',
    find: /\b(?:given|gives?|gave) up\b/iu,
    advice: 'write unload, terminate, cancel or time out',
    bad: 'The module is given up after a minute.',
    good: 'The module is unloaded after a minute.',
  },
  {
    id: 'kept',
    find: /\b(?:is|are|was|were|be|been|not|what) kept\b|\bkept (?:by|in|for|as|apart|with)\b/iu,
    advice: 'write stored, cached, retained or preserved',
    bad: 'The mask is kept with the project.',
    good: 'The mask is stored in the project.',
  },
  {
    id: 'archaic',
    find: /\banew\b|\bin the place of\b|\blest\b|\bwhereby\b|\bwherein\b|\bthereof\b|\bwhosoever\b/iu,
    advice: 'write again, instead of, so that ... not',
    bad: 'The page is drawn anew.',
    good: 'The page is drawn again.',
  },
  {
    id: 'own',
    find: /\bof (?:one|its|their|his|her|our|your)(?:['’]s)? own\b|\bone['’]s own\b/iu,
    advice: 'write separate, dedicated, custom or your',
    bad: 'Masks have a module of their own.',
    good: 'Masks have a separate module.',
  },
  {
    id: 'is-no',
    find: /(?<!\b[Tt]here )\b(?:is|are|was|were) no (?!longer|more|less|fewer|larger|smaller|way|need|such|reason|doubt|exception|other|better|worse|different)\w+/iu,
    advice: 'write is not a, or there is no',
    bad: 'The file is no project.',
    good: 'The file is not a project.',
  },
  {
    id: 'none',
    find: /\bnone (?:where|for|if|when|that|but|at|in)\b|[,;] (?:else )?none\b|\b(?:is|are|was|were|has|have|gives?) none\b|\bfor none\b/u,
    advice: 'say what is returned, or which things are missing',
    bad: 'Returns the mask, none where there is no figure.',
    good: 'Returns the mask, or `None` without a subject.',
  },
  {
    id: 'else',
    find: /\ball else\b|[,;] else\b|(?<!where |thing |one |body |how )\belse (?:the|it|they|a|as|no|to|with|by|in|on)\b|^Else\b/iu,
    advice: 'write otherwise, or everything else',
    bad: 'It uses the mask, else the box.',
    good: 'It uses the mask. Without a mask it uses the box.',
  },
  {
    id: 'but',
    find: /\b(?:[Aa]ll|[Nn]one|[Nn]othing|[Nn]obody|no one|anything|everything|any|not) but\b|(?<![,;] )\bbut for\b|\b(?:shows?|has|have|is|are|lacks?|needs?) but (?:a|one|the|its)\b/u,
    advice: 'write except, other than or only',
    bad: 'All but the first are drawn.',
    good: 'The first one is skipped. The others are drawn.',
  },
  {
    id: 'hang',
    find: /\bhangs? (?:together|on)\b/iu,
    advice: 'write be linked, be connected or depend on',
    bad: 'Balloons that hang together share a tail.',
    good: 'Linked balloons share a tail.',
  },
  {
    id: 'a-for-per',
    find: new RegExp(
      `\\b(?:one|two|three|four|eight|\\d[\\d.,]*|files?|rows?|lines?|dots|pixels|frames|pictures|photos|bytes|bits|letters|words|numbers?|masks?|panels|pages|seconds|milliseconds|ms|degrees?) an? (?:${UNITS})\\b(?! (?:of|in|that|which|is|at|with|from|on)\\b)`,
      'iu',
    ),
    advice: 'write per',
    bad: 'One file a language.',
    good: 'One file per language.',
  },
  {
    id: 'fronted-of',
    find: new RegExp(`${START}Of (?!course)\\w+|^[A-Z]\\w* of (?:what|which|that|those)\\b`, 'u'),
    advice: 'put the subject first',
    bad: 'Of each film the first frame is used.',
    good: 'The first frame of each video is used.',
  },
  {
    id: 'ghost',
    find: /\bwhoever\b|\bsomebody\b|\bnobody\b|\banybody\b|\bsomeone\b|\b(?:to|for|by|of|with) who\b|\bone['’]s\b|\bthose who\b|\b(?:what|where|when|if|that|as|which|until|whether) (?:a person|people) /iu,
    advice: 'name the actor: the user, the caller, the worker, the browser',
    bad: 'Whoever needs it fetches it.',
    good: 'Each module loads it on demand.',
  },
  {
    id: 'where-if',
    find: /^Where (?!to\b)[^?]*$|[;:] where (?:it|they|that|there|one|a|an|the|no|any|some|nothing|all|both)\b|\b(?:nothing|none|error|fails?|false|true|zero|empty|only|but|even|except|as|not|also|null|refused|still) where\b|\bwhere (?:it|they|there|that|this|he|she|no \w+|one|nothing|a \w+|the \w+|an \w+) (?:is|are|was|has|have|can|cannot|does|do|asks?|lacks?|needs?|knows?|allows?|gives?|says?|wants?) (?:no|none|not|one|any|nothing)\b|\bwhere (?:there|one|no|not|nothing)\b/u,
    advice: 'write if or when for a condition; where is for places',
    bad: 'Where there is no mask, the photo counts.',
    good: 'Without a mask, the photo counts.',
  },
  {
    id: 'alone',
    find: /(?<!\b(?:leave|leaves|left|leaving|let|stand|stands|standing|is|are|works?|run|runs)\b(?: \w+){0,4}) alone\b(?! in)/iu,
    advice: 'put only before the word',
    bad: 'It changes the lines alone.',
    good: 'It changes only the lines.',
  },
  {
    id: 'by-itself',
    find: /\bby (?:itself|themselves|themself|hand)\b/iu,
    advice: 'write automatically, manually or separately',
    bad: 'Words are placed by themselves.',
    good: 'Text is placed automatically.',
  },
  {
    id: 'by-which',
    find: /\b(?:by|of|without|beside|behind|over|among) (?:which|whose)\b/iu,
    advice: 'start a new sentence',
    bad: 'Twelve photos, of which one is dark.',
    good: 'Twelve photos. One of them is dark.',
  },
  {
    id: 'that-which',
    find: /\bthat which\b|\bthose (?:of|that|which|whose|in|on|with|for|by)\b|\bthat of\b/iu,
    advice: 'repeat the noun',
    bad: 'The order is that of the list.',
    good: 'The order follows the list.',
  },
  {
    id: 'the-same',
    find: /^The same(?: (?:for|of|as|but|where|with|by|when|from|in|on|at|to|again)\b|[,.:;]|$)/u,
    advice: 'name the thing again and say what differs',
    bad: 'The same for a page.',
    good: 'Like `draw`, for one page.',
  },
  {
    id: 'so-many',
    find: /\bso (?:many|much|long|few)\b(?! (?:as|faster|slower|smaller|larger|better|that)\b)/iu,
    advice: 'write N, this many, or give the number',
    bad: 'Wait for so many seconds.',
    good: 'Wait for N seconds.',
  },
  {
    id: 'stands',
    find: /\b(?:stands?|stood|standing) (?:in|for|with|there|behind|beside|on|where|as|by|at|before|after|between|beneath|below|above)\b/iu,
    advice: 'write is, is stored in, represents or follows',
    bad: 'The text stands in the file.',
    good: 'The text is in the file.',
  },
  {
    id: 'said',
    find: /\b(?:is|are|was|were|be|as|has|have|it) said\b|\bhas (?:a|no) say\b|\bsays? (?:nothing|so|of|it|them)\b|\b(?:nothing|something) to say\b/iu,
    advice: 'write reported, stated or specified',
    bad: 'The size is said in the file.',
    good: 'The file specifies the size.',
  },
  {
    id: 'asked',
    find: /\b(?:as|unless|if|when|where) (?:it |they |he |one )?(?:is|was|are|were)? ?asked\b|\bwhat (?:is|was) asked\b|\basked of\b/iu,
    advice: 'write requested, or name the option',
    bad: 'The number is as it was asked for.',
    good: 'The number matches the request.',
  },
  {
    id: 'whole',
    find: /\bwhole or not at all\b|\bcut short\b|\bbreaks? off\b|\bbroke off\b/iu,
    advice: 'write atomically or truncated',
    bad: 'A file that is cut short is refused.',
    good: 'A truncated file is rejected.',
  },
  {
    id: 'metaphor',
    find: /\bjourneys?\b|\bways? (?:in|out)\b(?! (?:which|that))|\bstrangers\b|\bhostile\b|\b(?:this|the|each|every|lower|upper|which|no) rooms?\b(?! for)|\brooms (?:of|below|above)\b/iu,
    advice: 'write entry point, export, untrusted input, malformed or module',
    bad: 'The ways in are the modules.',
    good: 'The entry points are the modules.',
  },
  {
    id: 'as-does',
    find: /\bas (?:it|they|ever|before|that) (?:is|are|was|were|stands?|did|does|has|had)(?: there| then| before)?(?:[.,;]|$)/iu,
    advice: 'write unchanged, or name the state',
    bad: 'The rest stays as it was.',
    good: 'Nothing else changes.',
  },
  {
    id: 'there-by',
    find: /\bby (?:then|now) (?:is|are|was|has)\b|\bis there (?:already|whole|again)\b|\bare there (?:already|whole|again)\b/iu,
    advice: 'write exists, is complete or is available',
    bad: 'The file is there already.',
    good: 'The file already exists.',
  },
];
