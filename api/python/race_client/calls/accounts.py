"""Routes of api/openapi.yaml: accounts. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import (Account, AccountChange, AccountCreate, AccountRemoved, AccountTokens, Accounts, TokenCreate,
                        TokenCreated, TokenRemoved)


def list_accounts() -> Call[Accounts]:
    """The accounts, by name."""
    return Call("GET", "/api/v1/accounts")


def create_account(body: AccountCreate) -> Call[Account]:
    """Makes an account. The first is an admin's, with a password; from then on everybody needs one.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be none
    (`out_of_range`).

    409: There is an account of this name (`conflict`).

    413: There are 200 accounts (`too_large`).

    422: The request does not fit its schema. `name`: that can be none; `missing`: a process has no group; `not_accepted`: another
    role has groups, a process has a password, or the first account is no admin's with a password.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/accounts", body=body)


def change_account(name: str, body: AccountChange) -> Call[Account]:
    """Changes role, component groups or password of an account; what is absent stays.

    A new password ends all its tokens. Its WebSockets end soon after if it has another role or other groups now, or their token
    has ended. A person does not become a process, nor a process a person.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be none
    (`out_of_range`).

    404: There is no such account (`not_found`).

    409: `conflict`: no admin with a password would be left.

    422: The request does not fit its schema. `missing`: a process would have no group; `not_accepted`: another role would have
    groups, a process a password, or a person would become a process or a process a person.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("PUT", f"/api/v1/accounts/{segment(name)}", body=body)


def delete_account(name: str) -> Call[AccountRemoved]:
    """Removes an account with all its tokens. What it has made stays; its WebSockets end soon after.

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: no admin with a password would be left.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("DELETE", f"/api/v1/accounts/{segment(name)}")


def list_tokens(name: str) -> Call[AccountTokens]:
    """The tokens of an account that have not expired, the oldest first. The secrets are not kept.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", f"/api/v1/accounts/{segment(name)}/tokens")


def create_token(name: str, body: TokenCreate) -> Call[TokenCreated]:
    """Makes a token of an account, for a program or a process.

    The answer alone has the secret. The token itself has no address; the list of tokens has its label and digest.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or `days` or `role` is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    413: The label has more than 100 characters, or the account has 100 tokens that are no logins (`too_large`).

    422: The request does not fit its schema; `not_accepted`: the label is `login`, the account may do less than `role`, or a
    process would have a role or be `local`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/accounts/{segment(name)}/tokens", body=body)


def revoke_token(name: str, digest: str) -> Call[TokenRemoved]:
    """Ends a token of an account. WebSockets that were opened by it end soon after.

    404: There is no such account, or it has no such token (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("DELETE", f"/api/v1/accounts/{segment(name)}/tokens/{segment(digest)}")
