// Lint of the pages, their tests and the browser tests.
import js from "@eslint/js";
import hooks from "eslint-plugin-react-hooks";
import { defineConfig } from "eslint/config";
import { fileURLToPath } from "node:url";
import ts from "typescript-eslint";

const root = fileURLToPath(new URL("..", import.meta.url));

export default defineConfig(
  { ignores: ["web/dist/**", "web/generated/**", "web/node_modules/**", "api/typescript/dist/**", "api/typescript/src/generated/**", "build/**"] },
  js.configs.recommended,
  {
    files: ["**/*.ts", "**/*.tsx"],
    extends: [ts.configs.strictTypeChecked, ts.configs.stylisticTypeChecked],
    rules: {
      "@typescript-eslint/no-unused-vars": ["error", { ignoreRestSiblings: true }],
      "@typescript-eslint/dot-notation": ["error", { allowIndexSignaturePropertyAccess: true }],
      "@typescript-eslint/no-confusing-void-expression": ["error", { ignoreArrowShorthand: true }],
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
    },
    languageOptions: { parserOptions: { project: "web/tsconfig.json", tsconfigRootDir: root } },
  },
  {
    files: ["**/*.mjs"],
    languageOptions: { globals: { URL: "readonly", console: "readonly", process: "readonly" } },
    rules: { "no-unused-vars": ["error", { ignoreRestSiblings: true }] },
  },
  { files: ["web/public/**"], languageOptions: { sourceType: "script", globals: { document: "readonly", localStorage: "readonly" } } },
  { files: ["web/pro/**", "web/one/**", "web/display/**", "web/stop/**", "web/control/**"], extends: [hooks.configs.flat.recommended] },
);
