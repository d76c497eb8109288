// Conversations about who asks.
import { all, refused } from "./asserting";
import { task } from "./models";
import { folderWithAccounts, kPassword, Server, tokenOf } from "./servers";

let server: Server;
beforeAll(async () => {
  server = await Server.start([], { data: folderWithAccounts() });
});
afterAll(() => server.stop());

describe("rights", () => {
  it("who is not known logs in", async () => {
    const race = server.client();
    await refused(401, "login", all(race.documents.all()));
    expect(await race.me()).toEqual({ accounts: true });
    await refused(401, "login", race.logIn("developer", "wrong horse battery"));
    expect((await race.logIn("developer", kPassword)).account.role).toBe("developer");
    expect((await race.me()).role).toBe("developer");
    expect((await race.documents.put("mine", task("ticking", { name: "mine" }), { isNew: true })).author).toBe("developer");
    const { id } = await race.cores.create("mine", { last: 1 });
    await race.cores.start(id);
    expect((await race.cores.wait(id, { timeout: 20 })).outcome, "the stream knows who it is, too").toBe("done");
    await race.logOut();
    await refused(401, "login", race.cores.get(id));
    await refused(401, "login", race.cores.follow(id));
  });

  it("a token may do what its role may", async () => {
    const observer = server.client({ token: tokenOf(server.data, "observer") });
    expect((await observer.me()).role).toBe("observer");
    await refused(403, "rights", observer.documents.put("theirs", task("ticking", { name: "theirs" })));
    await refused(403, "rights", observer.services.call("db", "add", ["x", 1]));
  });

  it("a token with other characters is not sent", () => {
    for (const token of ["", "a b", "a\r\nX-Evil: 1", "ä"]) expect(() => server.client({ token })).toThrow(TypeError);
  });
});
