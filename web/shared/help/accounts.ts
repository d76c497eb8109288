// Who may use a server, and from where (server/accounts, server/tls).
import { kRoles, kRoleTexts } from "../login/roles";
import { code, heading, list, terms, text, type Topic } from "./blocks";

const group = "Server" as const;

export const accounts: readonly Topic[] = [
  {
    id: "accounts", title: "Accounts and roles", group,
    blocks: [
      text("A server without accounts answers its own machine alone, and whoever sits there may do everything. The first account ends that: from then on the page asks for a login, and each account may do what its role allows."),
      terms(...kRoles.map((role) => [role, kRoleTexts[role]] as const)),
      text("Each role may do what those before it may. What yours may not do is grey, and its tooltip says which role it needs. Edits, comments and breakpoints are signed with the account, and what was done is in the audit log of the server."),
      heading("Making accounts"),
      text("The first one is made on the machine of the server, while it does not run; the command asks for a password of at least 10 characters:"),
      code("race account add ada --role admin --data DIR"),
      text("After that, an admin makes, changes and removes accounts on the page: the button with your name, top right, then Accounts."),
      list("`race account list --data DIR` shows all accounts.", "`race account password NAME --data DIR` gives a new password to who has forgotten it.", "`race account role NAME --role ROLE --data DIR` gives another role. At least one admin stays."),
    ],
  },
  {
    id: "login", title: "Logging in, and tokens for programs", group,
    blocks: [
      text("A login lasts for all pages of the browser. Who logs in, logs out or changes the account on one of them does so on all of them. The page stays as it was below the login, and goes on when somebody has logged in. After several wrong passwords the server makes you wait."),
      heading("Programs"),
      text("A program has no password but a token, which an admin makes for an account of its own. It is printed once; the server keeps only its digest."),
      code("race account add nightly --role operator --data DIR", "race account token nightly --label tests --days 90 --data DIR > nightly.token"),
      text("The commands of `race` take it from the file that `--token-file` names, or from the environment; any other program sends it as `Authorization: Bearer TOKEN`:"),
      code("export RACE_TOKEN=$(cat nightly.token)"),
      text("Who has the token is the account. Keep it like a password: readable by its program alone, and in no version control."),
      text("A process of services (`race service`) has an account of the role process, which may do nothing but bring its component groups: `race account add cell-pc --role process --groups cell --data DIR`."),
    ],
  },
  {
    id: "network", title: "Phones and other computers: the network", group,
    blocks: [
      text("Without `--lan`, the server listens on its own machine alone. With it, it also serves the local network, at port 8443 and over TLS; for that it needs at least one account:"),
      code("race serve --lan --data DIR"),
      text("It prints the addresses at which the network reaches it, and the fingerprint of its certificate authority. Nobody signs certificates for a machine in a workshop, so the server has an authority of its own; a device trusts it once, and browsers warn no more. It can vouch for private addresses and local names only, and for no other site."),
      list("Open `/trust/` at one of the addresses on the device: it leads through the steps for Android, iPhone, Windows, macOS and Linux.", "Compare the fingerprint there with what the server has printed, or with what `/trust/` shows on its own machine.", "Then open the page, or the display of a phone: Pair a phone shows its code."),
      text("Commands on another computer trust the authority by its certificate, `tls/ca.pem` in the data folder of the server, or what `/trust/` gives: `race core list --server https://ADDRESS:8443 --ca ca.pem`. A process of services connects on the machine of the server, or through a tunnel."),
      text("Do not lead the port to the internet: the server is made for a local network."),
    ],
  },
];
