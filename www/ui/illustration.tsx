/** A page in ink: slanted panels with hatching, dots and speed lines, in the colours of the theme. */
export function Illustration() {
  return (
    <svg class="illustration" viewBox="0 0 420 460" aria-hidden="true">
      <defs>
        <pattern id="ink-dots" width="9" height="9" patternUnits="userSpaceOnUse" patternTransform="rotate(30)">
          <circle cx="4.5" cy="4.5" r="2.4" class="ink-accent" />
        </pattern>
        <pattern id="ink-hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(-38)">
          <rect width="2.6" height="7" class="ink-dark" />
        </pattern>
        <clipPath id="ink-a">
          <path d="M54 52h312v118L54 206z" />
        </clipPath>
        <clipPath id="ink-b">
          <path d="M54 222l148-17v203H54z" />
        </clipPath>
        <clipPath id="ink-c">
          <path d="M218 203l148-17v112l-148 18z" />
        </clipPath>
        <clipPath id="ink-d">
          <path d="M218 332l148-18v94H218z" />
        </clipPath>
      </defs>
      <g class="ink-back">
        <rect x="52" y="44" width="330" height="390" rx="5" transform="rotate(7 210 230)" />
      </g>
      <g class="ink-back">
        <rect x="38" y="38" width="330" height="390" rx="5" transform="rotate(-5 210 230)" />
      </g>
      <rect class="ink-paper" x="38" y="36" width="344" height="388" rx="5" />
      <g clip-path="url(#ink-a)">
        <rect class="ink-sky" x="40" y="40" width="340" height="180" />
        <circle cx="288" cy="104" r="42" class="ink-accent" />
        <path class="ink-dark" d="M40 182l70-62 34 30 42-46 70 66 46-30 90 60v40H40z" />
        <path fill="url(#ink-hatch)" class="ink-veil" d="M186 104l70 66 46-30 90 60v40H150z" />
      </g>
      <g clip-path="url(#ink-b)">
        <rect class="ink-light" x="50" y="200" width="160" height="220" />
        <rect fill="url(#ink-dots)" x="50" y="200" width="160" height="220" />
        <path
          class="ink-dark"
          d="M96 420c0-44 8-62 24-72-14-10-20-24-18-40 3-22 18-34 36-33 20 1 32 17 30 38-1 14-8 26-18 33 22 12 32 38 32 78z"
        />
      </g>
      <g clip-path="url(#ink-c)">
        <rect class="ink-dark" x="210" y="180" width="170" height="150" />
        <path
          class="ink-rays"
          d="M292 252l-90-60M292 252l-96-14M292 252l-90 46M292 252l-34 76M292 252l30 74M292 252l92 40M292 252l96-16M292 252l70-72M292 252l10-80M292 252l-40-70"
        />
        <path
          class="ink-paper"
          d="M292 214l11 22 24-8-8 24 22 11-22 11 8 24-24-8-11 22-11-22-24 8 8-24-22-11 22-11-8-24 24 8z"
        />
      </g>
      <g clip-path="url(#ink-d)">
        <rect class="ink-light" x="210" y="310" width="170" height="110" />
        <rect fill="url(#ink-hatch)" class="ink-veil" x="210" y="362" width="170" height="50" />
        <path class="ink-accent" d="M232 392c20-40 44-52 62-50 26 3 44 24 58 50z" />
        <path class="ink-dark" d="M262 392c12-20 24-28 38-28 16 0 26 10 36 28z" />
      </g>
      <g class="ink-frames">
        <path d="M54 52h312v118L54 206z" />
        <path d="M54 222l148-17v203H54z" />
        <path d="M218 203l148-17v112l-148 18z" />
        <path d="M218 332l148-18v94H218z" />
      </g>
    </svg>
  );
}
